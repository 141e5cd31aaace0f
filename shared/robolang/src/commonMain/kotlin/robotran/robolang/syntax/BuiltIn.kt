package robotran.robolang.syntax

/**
 * The built-in functions. Angles are in degrees.
 *
 * @property text its name in Robolang.
 * @property parameters the number of parameters.
 */
internal enum class BuiltIn(val text: String, val parameters: Int) {
    /** A whole number between two whole numbers inclusive. */
    RANDOM("random", 2),

    /** Whole for a whole number, otherwise decimal. */
    ABS("abs", 1),

    /** Whole for two whole numbers, otherwise decimal. */
    MIN("min", 2),

    /** Whole for two whole numbers, otherwise decimal. */
    MAX("max", 2),

    /** The nearest whole number; halves round up. */
    ROUND("round", 1),

    /** The whole number below. */
    FLOOR("floor", 1),

    /** The whole number above. */
    CEIL("ceil", 1),

    SQRT("sqrt", 1),

    SIN("sin", 1),

    COS("cos", 1),

    TAN("tan", 1),

    /** The direction in degrees to a point; the first value is up, the second right, as in Java. */
    ATAN2("atan2", 2),

    /** The first to the power of the second. */
    POW("pow", 2),

    /** The number of elements of a list. */
    LENGTH("length", 1),
    ;

    companion object {
        private val byText = entries.associateBy { it.text }

        /** The function [key], a name in lower case. */
        fun of(key: String): BuiltIn? = byText[key]
    }
}
