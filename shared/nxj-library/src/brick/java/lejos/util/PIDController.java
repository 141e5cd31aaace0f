package lejos.util;

import java.io.IOException;

/**
 * Works out what to do about an error: from the error itself, from its sum and from its change.
 *
 * <p>The error is what the value should be, minus what it is. Times are in milliseconds: in each call, the sum grows
 * by the error times PID_KI times the milliseconds between the two calls before, and the change of the error is divided
 * by them. The first call gives 0. In the second one, no time has passed, so the change is infinite, or counts nothing
 * and makes the output 0 if PID_KD is 0: leave some milliseconds between two calls.
 */
public class PIDController {
    /** How much the error itself counts; 1 to begin with. */
    public static final int PID_KP = 0;

    /** How much the sum of errors counts, for each millisecond; 0 to begin with. */
    public static final int PID_KI = 1;

    /** How much the change of the error in a millisecond counts; 0 to begin with. */
    public static final int PID_KD = 2;

    /** The power of the ramp: 1 for a straight one, 0 for none. */
    public static final int PID_RAMP_POWER = 3;

    /** Up to this output there is a ramp; 0 for none. */
    public static final int PID_RAMP_THRESHOLD = 4;

    /** Errors up to this one do not count. */
    public static final int PID_DEADBAND = 5;

    /** The highest output; 900 to begin with. */
    public static final int PID_LIMITHIGH = 6;

    /** The lowest output; -900 to begin with. */
    public static final int PID_LIMITLOW = 7;

    /** What the value should be. */
    public static final int PID_SETPOINT = 8;

    /** The lowest sum of errors; the sum has limits as long as the limit that was set last is not 0. */
    public static final int PID_I_LIMITLOW = 9;

    /** The highest sum of errors; the sum has limits as long as the limit that was set last is not 0. */
    public static final int PID_I_LIMITHIGH = 10;

    /** The sum of errors, times PID_KI, at this moment; it can only be asked for. */
    public static final int PID_I = 11;

    /** The value of the last call; it can only be asked for. */
    public static final int PID_PV = 12;

    private static final int COUNT = 11;

    private final float[] values = new float[COUNT];
    private int delay;
    private double rampExtent = 1;
    private float sum;
    private boolean hasLimits;
    private boolean isFrozen;
    private int value;
    private int errorBefore;
    private float change;
    private long last;
    private int passed;
    private Logger logger;
    private int rows;

    /**
     * Makes one for what the value should be, without waiting.
     *
     * @hidden
     */
    public PIDController(int setpoint) {
        this(setpoint, 0);
    }

    /** Makes one for what the value should be that is asked every so many milliseconds; 0 for no waiting. */
    public PIDController(int setpoint, int msdelay) {
        values[PID_SETPOINT] = setpoint;
        values[PID_KP] = 1;
        values[PID_LIMITHIGH] = 900;
        values[PID_LIMITLOW] = -900;
        delay = msdelay;
    }

    /** Sets one of the numbers, such as PID_KP; the sum of errors begins with 0 again. */
    public void setPIDParam(int param, float value) {
        if (param < 0 || param >= COUNT) return;
        boolean isWhole = param >= PID_RAMP_THRESHOLD && param <= PID_SETPOINT;
        values[param] = isWhole ? (int) value : value;
        if (param == PID_I_LIMITLOW || param == PID_I_LIMITHIGH) hasLimits = value != 0;
        if (param == PID_RAMP_POWER || param == PID_RAMP_THRESHOLD && values[param] != 0) {
            rampExtent = Math.pow(values[PID_RAMP_THRESHOLD], values[PID_RAMP_POWER]);
        }
        sum = 0;
    }

    /** Gives one of the numbers, such as PID_KP; 0 if there is no such number. */
    public float getPIDParam(int param) {
        if (param == PID_I) return sum;
        if (param == PID_PV) return value;
        return param < 0 || param >= COUNT ? 0 : values[param];
    }

    /** Says whether the sum of errors is to stay as it is. */
    public void freezeIntegral(boolean freeze) {
        isFrozen = freeze;
    }

    /** Says whether the sum of errors stays as it is. */
    public boolean isIntegralFrozen() {
        return isFrozen;
    }

    /** Sets the milliseconds from one call to the next; 0 for no waiting. */
    public void setDelay(int msdelay) {
        delay = msdelay;
    }

    /** Gives the milliseconds from one call to the next. */
    public int getDelay() {
        return delay;
    }

    /** Works out what to do about the value, waits until it is time, and gives it; the first call gives 0 at once. */
    public int doPID(int processVariable) {
        value = processVariable;
        if (last == 0) {
            last = System.currentTimeMillis();
            return 0;
        }
        int output = ramped(output());
        if (logger != null && rows > 2) log(output);
        rows++;
        if (delay > 0) {
            int rest = delay - (int) (System.currentTimeMillis() - last);
            if (rest > 0) Delay.msDelay(rest);
        }
        long now = System.currentTimeMillis();
        passed = (int) (now - last);
        last = now;
        return output;
    }

    /** Lets a logger write a row in each call, from the fifth one on; false if its columns were set before. */
    public boolean registerDataLogger(Logger dataLogger) {
        try {
            dataLogger.setColumns(new LogColumn[] {
                new LogColumn("SP", LogColumn.DT_INTEGER), new LogColumn("MV", LogColumn.DT_INTEGER),
                new LogColumn("PV", LogColumn.DT_INTEGER), new LogColumn("Integral", LogColumn.DT_FLOAT),
                new LogColumn("Kp*error", LogColumn.DT_FLOAT), new LogColumn("Kd*derivative", LogColumn.DT_FLOAT, 2),
                new LogColumn("error", LogColumn.DT_INTEGER), new LogColumn("dt", LogColumn.DT_INTEGER),
            });
        } catch (UnsupportedOperationException setBefore) {
            return false;
        }
        logger = dataLogger;
        return true;
    }

    /** Lets the logger write no more, and gives it, or null. */
    public Logger deregisterDataLogger() {
        Logger before = logger;
        logger = null;
        return before;
    }

    private void log(int output) {
        logger.writeLog((int) values[PID_SETPOINT]);
        logger.writeLog(output);
        logger.writeLog(value);
        logger.writeLog(sum);
        logger.writeLog(values[PID_KP] * errorBefore);
        logger.writeLog(values[PID_KD] * change);
        logger.writeLog(errorBefore);
        logger.writeLog(passed);
        try {
            logger.finishLine();
        } catch (IOException lost) {
            logger.stopLogging();
            logger = null;
        }
    }

    private int output() {
        int error = (int) values[PID_SETPOINT] - value;
        if (Math.abs(error) <= values[PID_DEADBAND]) error = 0;
        if (!isFrozen) sum += values[PID_KI] * error * passed;
        if (hasLimits) {
            if (sum > values[PID_I_LIMITHIGH]) sum = values[PID_I_LIMITHIGH];
            if (sum < values[PID_I_LIMITLOW]) sum = values[PID_I_LIMITLOW];
        }
        change = (float) (error - errorBefore) / passed;
        errorBefore = error;
        int output = (int) (values[PID_KP] * error + sum + values[PID_KD] * change);
        if (output > values[PID_LIMITHIGH]) output = (int) values[PID_LIMITHIGH];
        return output < values[PID_LIMITLOW] ? (int) values[PID_LIMITLOW] : output;
    }

    private int ramped(int output) {
        float threshold = values[PID_RAMP_THRESHOLD];
        if (values[PID_RAMP_POWER] == 0 || threshold == 0 || Math.abs(output) > threshold) return output;
        int size = (int) (Math.pow(Math.abs(output), values[PID_RAMP_POWER]) / rampExtent * threshold);
        return output < 0 ? -size : size;
    }
}
