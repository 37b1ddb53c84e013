/* Tokens of specifications. The rules only match; lexer_sink.cpp decides and reports.
   A number, and the `[` of `: real [m/s]`, is followed by the state UNIT up to the end of its
   line, so that units are told from names by their place. */
%option reentrant noyywrap 8bit nounput noinput nodefault never-interactive batch
%option prefix="rtac_syntax_"
%option extra-type="rtac::syntax::LexerSink*"

%top{
#include "compiler/syntax/lexer_sink.h"
}

%{
#define YY_USER_ACTION yyextra->advance(static_cast<std::size_t>(yyleng));
// Gives all but the first `length` bytes of the match back.
#define KEEP(length)                            \
  do {                                          \
    const auto keep_length = (length);          \
    yyextra->keep(keep_length);                 \
    yyless(static_cast<int>(keep_length));      \
  } while (false)
#define MATCH (std::string_view{yytext, static_cast<std::size_t>(yyleng)})
using T = rtac::syntax::T;
%}

%x UNIT
%x COMMENT
%x LONGTEXT

DIGIT      [0-9]
WORD       [A-Za-z_][A-Za-z0-9_]*
NUMBER     {DIGIT}+(\.{DIGIT}+)?([eE][+-]?{DIGIT}+)?
  /* Moments as they are written somewhere; which of them there are is for the checker to say. */
DATE       {DIGIT}+-{DIGIT}+-{DIGIT}+
TIME       {DIGIT}+(:{DIGIT}+)+(\.{DIGIT}+)?
ZONE       [A-Za-z]+|[+-]{DIGIT}+(:{DIGIT}+)?
UNITPART   ([A-Za-z][A-Za-z0-9_]*|%)(\^-?{DIGIT}+)?
HIGH       [\x80-\xFF]
  /* Typographic quotes: U+201C to U+201E, closed by U+201C or U+201D. */
OPENQUOTE  \xE2\x80[\x9C-\x9E]
CLOSEQUOTE \xE2\x80[\x9C\x9D]
INQUOTES   ([^\n\xE2]|\xE2[^\x80\n]|\xE2\x80[^\x9C\x9D\n])*

%%
  /* A comment returns to the state that it interrupts. */
  int resume = INITIAL;

<INITIAL,UNIT>{
  [ \t\r]+                {}
  "//"[^\n]*              {}
  "/*"                    { yyextra->comment_start(); resume = YY_START; BEGIN(COMMENT); }
}
<INITIAL>\n               { yyextra->line_break(); }

<COMMENT>{
  "*/"                    { BEGIN(resume); }
  [^*\n]+                 {}
  "*"                     {}
  \n                      { yyextra->line_break(); }
  <<EOF>>                 { yyextra->unterminated_comment(); yyextra->end_of_file(); return 0; }
}

<UNIT>{
  /* `1/s`: a rate of a plain number; no other unit starts with a digit. */
  ({UNITPART}|"1/"{UNITPART})([*/]{UNITPART})*  {
                            if (!yyextra->unit(MATCH)) KEEP(0U);
                            BEGIN(INITIAL);
                          }
  [A-Za-z0-9%^*/]*{HIGH}[A-Za-z0-9%^*/\x80-\xFF]*  {
                            KEEP(yyextra->foreign_unit(MATCH));
                            BEGIN(INITIAL);
                          }
  .|\n                    { KEEP(0U); BEGIN(INITIAL); }
}

{DATE}"T"{TIME}{ZONE}?    { yyextra->moment(MATCH); }
{TIME}{ZONE}?             { yyextra->moment(MATCH); }

{NUMBER}                  { yyextra->number(MATCH); BEGIN(UNIT); }
  /* `0..3` is a range and not a number with too many points. */
{NUMBER}/".."             { yyextra->number(MATCH); BEGIN(UNIT); }
{DIGIT}+("."{DIGIT}+)*"." { yyextra->malformed_number(MATCH); BEGIN(UNIT); }
{DIGIT}+("."{DIGIT}+){2,} { yyextra->malformed_number(MATCH); BEGIN(UNIT); }
"."{DIGIT}+               { yyextra->malformed_number(MATCH); BEGIN(UNIT); }
"0"[xX][0-9A-Fa-f]+       { yyextra->malformed_number(MATCH); BEGIN(UNIT); }
{DIGIT}+(_{DIGIT}+)+      { yyextra->malformed_number(MATCH); BEGIN(UNIT); }

{OPENQUOTE}{INQUOTES}{CLOSEQUOTE}  { yyextra->foreign_quotes(MATCH, 3); }
{WORD}                    { yyextra->word(MATCH); }
({WORD}|{HIGH})[A-Za-z0-9_\x80-\xFF]*  { KEEP(yyextra->foreign_run(MATCH)); }

\"([^"\\\n]|\\.)*\"       { yyextra->string(MATCH); }
\"([^"\\\n]|\\.)*\\?      {
                            if (yyextra->continues()) {
                              yyextra->long_string_start();
                              BEGIN(LONGTEXT);
                            } else {
                              KEEP(yyextra->unterminated_string(MATCH));
                            }
                          }
<LONGTEXT>{
  [^"\n]+                 {}
  \n                      { yyextra->line_break(); }
  \"                      { yyextra->long_string_end(); BEGIN(INITIAL); }
}
"'"[^'\n]*"'"             { yyextra->foreign_quotes(MATCH, 1); }
"#"[^\n]*                 { yyextra->hash_comment(); }

";"                       { yyextra->punctuation(T::SEMICOLON); }
":"                       { yyextra->punctuation(T::COLON); }
","                       { yyextra->punctuation(T::COMMA); }
"."                       { yyextra->punctuation(T::DOT); }
".."                      { yyextra->punctuation(T::DOT_DOT); }
"@"                       { yyextra->punctuation(T::AT_SIGN); }
"="                       { yyextra->punctuation(T::ASSIGN); }
"("                       { yyextra->punctuation(T::LEFT_PAREN); if (yyextra->stopped()) return 0; }
")"                       { yyextra->punctuation(T::RIGHT_PAREN); }
"["                       {
                            yyextra->punctuation(T::LEFT_BRACKET);
                            if (yyextra->stopped()) return 0;
                            if (yyextra->in_type()) BEGIN(UNIT);
                          }
"]"                       { yyextra->punctuation(T::RIGHT_BRACKET); }
"{"                       { yyextra->punctuation(T::LEFT_BRACE); if (yyextra->stopped()) return 0; }
"}"                       { yyextra->punctuation(T::RIGHT_BRACE); }
"<"                       { yyextra->punctuation(T::LESS); }
"<="                      { yyextra->punctuation(T::LESS_EQUAL); }
">"                       { yyextra->punctuation(T::GREATER); }
">="                      { yyextra->punctuation(T::GREATER_EQUAL); }
"=="                      { yyextra->punctuation(T::EQUAL); }
"!="                      { yyextra->punctuation(T::NOT_EQUAL); }
"|"                       { yyextra->punctuation(T::PIPE); }
"&"                       { yyextra->punctuation(T::AMPERSAND); }
"+"                       { yyextra->punctuation(T::PLUS); }
"-"                       { yyextra->punctuation(T::MINUS); }
"*"                       { yyextra->punctuation(T::STAR); }
"/"                       { yyextra->punctuation(T::SLASH); }

"=>"|"->"                 { yyextra->foreign_operator(T::IMPLIES, MATCH); }
"<=>"|"<->"               { yyextra->foreign_operator(T::IFF, MATCH); }
"&&"                      { yyextra->foreign_operator(T::AND, MATCH); }
"||"                      { yyextra->foreign_operator(T::OR, MATCH); }
"!"                       { yyextra->foreign_operator(T::NOT, MATCH); }
"<>"                      { yyextra->foreign_operator(T::NOT_EQUAL, MATCH); }
"=<"                      { yyextra->foreign_operator(T::LESS_EQUAL, MATCH); }
":="                      { yyextra->foreign_operator(T::ASSIGN, MATCH); }

.                         { yyextra->unknown(); }
<INITIAL,UNIT,LONGTEXT><<EOF>>     { yyextra->end_of_file(); return 0; }
%%

// Declared in lexer.cpp, which has no access to the types of the scanner.
namespace rtac::syntax {

void scan(std::string_view text, LexerSink& sink) {
  yyscan_t scanner = nullptr;
  if (yylex_init_extra(&sink, &scanner) != 0) return;
  yy_scan_bytes(text.data(), static_cast<int>(text.size()), scanner);
  yylex(scanner);
  yylex_destroy(scanner);
}

}  // namespace rtac::syntax
