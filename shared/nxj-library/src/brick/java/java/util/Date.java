package java.util;

/**
 * A day and a time of day, as far as a program sets them.
 *
 * <p>A brick does not know what day it is: a new date is the first of January 2000, at midnight. It does not compare
 * dates either.
 */
public class Date {
    private int year = 2000;
    private int month = 1;
    private int day = 1;
    private int hours;
    private int minutes;
    private int seconds;
    private long time = System.currentTimeMillis();

    /** Makes the first of January 2000, at midnight. */
    public Date() {
    }

    /**
     * Makes one with a number of milliseconds.
     *
     * @hidden
     */
    public Date(long time) {
        this.time = time;
    }

    /** Gives the year, such as 2000. */
    public int getYear() {
        return year;
    }

    /** Sets the year by its last two digits, 0 to 99. */
    public void setYear(int year) {
        if (year >= 0 && year <= 99) this.year = 2000 + year;
    }

    /** Gives the month, 1 to 12. */
    public int getMonth() {
        return month;
    }

    /** Sets the month, 1 to 12. */
    public void setMonth(int month) {
        if (month >= 1 && month <= 12) this.month = month;
    }

    /** Gives the day of the month, 1 to 31. */
    public int getDate() {
        return day;
    }

    /** Sets the day of the month, 1 to 31. */
    public void setDate(int day) {
        if (day >= 1 && day <= 31) this.day = day;
    }

    /** Gives the hour, 0 to 23. */
    public int getHours() {
        return hours;
    }

    /** Sets the hour, 0 to 23. */
    public void setHours(int hours) {
        if (hours >= 0 && hours <= 23) this.hours = hours;
    }

    /** Gives the minute, 0 to 59. */
    public int getMinutes() {
        return minutes;
    }

    /** Sets the minute, 0 to 59. */
    public void setMinutes(int minutes) {
        if (minutes >= 0 && minutes <= 59) this.minutes = minutes;
    }

    /** Gives the second, 0 to 59. */
    public int getSeconds() {
        return seconds;
    }

    /** Sets the second, 0 to 59. */
    public void setSeconds(int seconds) {
        if (seconds >= 0 && seconds <= 59) this.seconds = seconds;
    }

    /** Gives false: a brick does not compare dates. */
    public boolean before(Date other) {
        return moment() < other.moment();
    }

    /** Gives false: a brick does not compare dates. */
    public boolean after(Date other) {
        return moment() > other.moment();
    }

    /**
     * Gives the milliseconds since the brick was switched on, or the number that was set.
     *
     * @hidden
     */
    public long getTime() {
        return time;
    }

    /**
     * Sets the number of milliseconds.
     *
     * @hidden
     */
    public void setTime(long time) {
        this.time = time;
    }

    private int moment() {
        return 1;
    }
}
