package java.util;

/** A moment, in milliseconds since the brick was switched on. */
public class Date {
    private long time;

    /** Makes one of this moment. */
    public Date() {
        this(System.currentTimeMillis());
    }

    /**
     * Makes one of a moment.
     *
     * @hidden
     */
    public Date(long time) {
        this.time = time;
    }

    /**
     * Gives the moment.
     *
     * @hidden
     */
    public long getTime() {
        return time;
    }

    /**
     * Sets the moment.
     *
     * @hidden
     */
    public void setTime(long time) {
        this.time = time;
    }

    /** Says whether both are the same moment. */
    public boolean equals(Object other) {
        return other instanceof Date && ((Date) other).time == time;
    }

    /** Gives a number that is the same for the same moment. */
    public int hashCode() {
        return (int) (time ^ time >>> 32);
    }
}
