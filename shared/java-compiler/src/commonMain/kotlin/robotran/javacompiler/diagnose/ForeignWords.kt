package robotran.javacompiler.diagnose

/**
 * Words of other languages, or of Java with other letters, and what Java says for them; an empty text where it has
 * nothing.
 */
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

/** Java's own words that pupils write with other letters. */
private val SMALL_WORDS = (
    "public private protected static final void class interface extends implements import package new return if else " +
        "while for do try " +
        "catch finally throw throws break continue int float double boolean char byte short long true false null " +
        "this super"
).split(' ').toSet()

/** What Java says for [word], an empty text if it has nothing for it, null if it is no such word. */
internal fun javaFor(word: String): String? = FOREIGN_WORDS[word]

/** The word of Java that [word] is but for capital letters. */
internal fun smallWord(word: String): String? = word.lowercase().takeIf { it != word && it in SMALL_WORDS }

/** Words of Java that a name can be a slip of but never means, and that nothing can be called. */
internal val KEYWORDS =
    SMALL_WORDS + "abstract case default instanceof native switch synchronized transient volatile goto const".split(' ')
