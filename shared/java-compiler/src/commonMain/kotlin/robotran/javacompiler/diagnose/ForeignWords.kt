package robotran.javacompiler.diagnose

/** Words of other languages or in the wrong case, with their Java equivalents; an empty string if there is none. */
private val FOREIGN_WORDS = mapOf(
    "elseif" to "else if",
    "elif" to "else if",
    "elsif" to "else if",
    "then" to "",
    "endif" to "}",
    "end" to "}",
    "and" to "&&",
    "or" to "||",
    "not" to "!",
    "<>" to "!=",
    "=<" to "<=",
    "=>" to ">=",
    "===" to "==",
    "!==" to "!=",
    "=!" to "!=",
    "bool" to "boolean",
    "integer" to "int",
    "str" to "String",
    "const" to "final",
    "let" to "int",
    "def" to "void",
    "function" to "void",
    "func" to "void",
    "fun" to "void",
    "sub" to "void",
    "nil" to "null",
    "None" to "null",
    "NULL" to "null",
    "Null" to "null",
    "self" to "this",
    "elseIf" to "else if",
)

/** Java's keywords, which pupils may write with capital letters. */
private val LOWERCASE_KEYWORDS = (
    "public private protected static final void class interface extends implements import package new return if else " +
        "while for do try " +
        "catch finally throw throws break continue int float double boolean char byte short long true false null " +
        "this super"
).split(' ').toSet()

/** Returns Java's equivalent of [word]: an empty string if it has none, null if [word] is not a foreign word. */
internal fun javaEquivalent(word: String): String? = FOREIGN_WORDS[word]

/** Returns the Java keyword that [word] equals except for its case; null if there is none. */
internal fun keywordInOtherCase(word: String): String? = word.lowercase().takeIf {
    it != word &&
        it in LOWERCASE_KEYWORDS
}

/** Reserved words: a name may be a typing error of one, but they are no valid names and are not suggested as names. */
internal val KEYWORDS =
    LOWERCASE_KEYWORDS +
        "abstract case default instanceof native switch synchronized transient volatile goto const".split(' ')
