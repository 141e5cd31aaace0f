package robotran.ecj;

/** The ids of the problems that come from the brick's limits, not from ECJ. */
public final class BrickProblem {
    public static final int SWITCH = -1;
    public static final int LONG_ARITHMETIC = -2;
    public static final int FLOAT_REMAINDER = -3;
    public static final int ARRAY_TYPE_TEST = -4;
    public static final int CLASS_LITERAL = -5;
    public static final int TEXT_JOINED_IN_LOOP = -6;

    /** Arguments: the divisor and the value that the brick uses instead. */
    public static final int DIVISOR_TOO_LARGE = -7;

    /** Arguments: the length and the max length. */
    public static final int ARRAY_TOO_LONG = -8;

    /** A source is too long, or there are too many. Argument: the max UTF-16 characters of all sources together. */
    public static final int SOURCE_TOO_LONG = -9;

    public static final int NESTED_TOO_DEEPLY = -10;

    private BrickProblem() {}
}
