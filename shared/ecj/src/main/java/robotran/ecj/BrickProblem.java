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

    /**
     * A {@code synchronized} method that a brick runs without a lock. Arguments: its name, {@code private} or
     * {@code static}, and the first of {@code wait}, {@code notify} and {@code notifyAll} that it calls without having
     * locked its object, or nothing.
     */
    public static final int UNLOCKED_METHOD = -11;

    /** A call of a synchronized method through {@code super}, without a lock on a brick. Argument: its name. */
    public static final int UNLOCKED_SUPER_CALL = -12;

    /** A text that is joined with a number. */
    public static final int TEXT_AND_NUMBER = -13;

    /** A class or member that a brick's class library lacks. Argument: its key, see {@link EcjCompiler#addGap}. */
    public static final int LIBRARY_GAP = -14;

    /** The compiler would need too long. Argument: the name of the method, class or file. */
    public static final int TOO_MUCH_WORK = -15;

    /** A {@code finally} whose copies would be too many, since it contains others or many ways lead out of its try. */
    public static final int FINALLY_COPIED_TOO_OFTEN = -16;

    /** Argument: the max imports of a file. */
    public static final int TOO_MANY_IMPORTS = -17;

    /** Argument: the max classes of a program. */
    public static final int TOO_MANY_CLASSES = -18;

    /** A constant outside -128 to 127 that is added to a local variable, as with {@code i += 128}. */
    public static final int LARGE_STEP = -19;

    /**
     * Two texts that are compared as objects. Arguments: {@code ==} or {@code !=}, the offset behind the left one or -1 if
     * no call can stand behind it, and the offset of the right one.
     */
    public static final int TEXTS_COMPARED = -20;

    private BrickProblem() {}
}
