package robotran.robolang.check

/**
 * The functions that are built in. Angles are in degrees.
 *
 * @property text how Robolang spells it.
 * @property parameters how many values it takes.
 */
internal enum class BuiltIn(val text: String, val parameters: Int) {
    /** A whole number from the first to the second, both included; takes whole numbers only. */
    RANDOM("random", 2),

    /** Whole of a whole number, decimal of a decimal one. */
    ABS("abs", 1),

    /** Whole of two whole numbers, otherwise decimal. */
    MIN("min", 2),

    /** Whole of two whole numbers, otherwise decimal. */
    MAX("max", 2),

    /** The nearest whole number, a half upwards. */
    ROUND("round", 1),

    /** The whole number below. */
    FLOOR("floor", 1),

    /** The whole number above. */
    CEIL("ceil", 1),

    SQRT("sqrt", 1),

    SIN("sin", 1),

    COS("cos", 1),

    TAN("tan", 1),

    /** The direction, in degrees, to a point that is the first value up and the second to the right, as in Java. */
    ATAN2("atan2", 2),

    /** The first to the power of the second. */
    POW("pow", 2),

    /** How many elements a list has. */
    LENGTH("length", 1),
    ;

    companion object {
        private val byText = entries.associateBy { it.text }

        /** The function of that name, in lower case. */
        fun of(key: String): BuiltIn? = byText[key]
    }
}
