package lejos.util;

/** A column of what a Logger writes: its name, its type, and how a chart shows it. */
public class LogColumn {
    /** The type boolean. */
    public static final int DT_BOOLEAN = 0;

    /** The type byte. */
    public static final int DT_BYTE = 1;

    /** The type short. */
    public static final int DT_SHORT = 2;

    /** The type int. */
    public static final int DT_INTEGER = 3;

    /** The type long. */
    public static final int DT_LONG = 4;

    /** The type float. */
    public static final int DT_FLOAT = 5;

    /** The type double. */
    public static final int DT_DOUBLE = 6;

    private static final int MOST_AXES = 4;

    private final String name;
    private final int type;
    private final boolean isInChart;
    private final int axis;

    /** Makes one of a name, for float values in a chart. */
    public LogColumn(String name) {
        this(name, DT_FLOAT);
    }

    /** Makes one of a name and a type such as DT_INTEGER, for a chart. */
    public LogColumn(String name, int datatype) {
        this(name, datatype, true);
    }

    /** Makes one of a name and a type such as DT_INTEGER, and says whether it is for a chart. */
    public LogColumn(String name, int datatype, boolean chartable) {
        this(name, datatype, chartable, 1);
    }

    /** Makes one of a name and a type such as DT_INTEGER, for an axis from 1 to 4 of a chart. */
    public LogColumn(String name, int datatype, int rangeAxisID) {
        this(name, datatype, true, rangeAxisID);
        if (rangeAxisID < 1 || rangeAxisID > MOST_AXES) {
            throw new IllegalArgumentException("Invalid rangeAxisID " + rangeAxisID);
        }
    }

    private LogColumn(String name, int datatype, boolean chartable, int rangeAxisID) {
        if (datatype < DT_BOOLEAN || datatype > DT_DOUBLE) {
            throw new IllegalArgumentException("Invalid datatype " + datatype);
        }
        this.name = name;
        type = datatype;
        isInChart = chartable;
        axis = rangeAxisID;
    }

    /** Gives how many bytes a value takes. */
    public int getSize() {
        return type == DT_LONG || type == DT_DOUBLE ? 8 : 4;
    }

    /** Gives the type, such as DT_INTEGER. */
    public int getDatatype() {
        return type;
    }

    /** Tells whether it is for a chart. */
    public boolean isChartable() {
        return isInChart;
    }

    /** Gives the axis of a chart, 1 to 4. */
    public int getRangeAxisID() {
        return axis;
    }

    /** Gives the name. */
    public String getName() {
        return name;
    }
}
