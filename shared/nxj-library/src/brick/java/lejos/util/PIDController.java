package lejos.util;

/** Works out what to do about an error: from the error itself, from its sum and from its change. */
public class PIDController {
    /** How much the error itself counts. */
    public static final int PID_KP = 0;

    /** How much the sum of errors counts. */
    public static final int PID_KI = 1;

    /** How much the change of the error counts. */
    public static final int PID_KD = 2;

    /** The power of the ramp. */
    public static final int PID_RAMP_POWER = 3;

    /** Below this output the ramp begins; 0 for no ramp. */
    public static final int PID_RAMP_THRESHOLD = 4;

    /** Errors up to this one do not count. */
    public static final int PID_DEADBAND = 5;

    /** The highest output. */
    public static final int PID_LIMITHIGH = 6;

    /** The lowest output. */
    public static final int PID_LIMITLOW = 7;

    /** What the value should be. */
    public static final int PID_SETPOINT = 8;

    /** The lowest sum of errors. */
    public static final int PID_I_LIMITLOW = 9;

    /** The highest sum of errors. */
    public static final int PID_I_LIMITHIGH = 10;

    private static final int COUNT = 11;

    private final float[] values = new float[COUNT];
    private final int delay;
    private float sum;
    private int previousError;
    private boolean isFrozen;
    private long last;

    /** Makes one for what the value should be. */
    public PIDController(int setpoint) {
        this(setpoint, 0);
    }

    /** Makes one for what the value should be that is asked every so many milliseconds. */
    public PIDController(int setpoint, int msdelay) {
        delay = msdelay;
        values[PID_SETPOINT] = setpoint;
        values[PID_KP] = 1;
        values[PID_RAMP_POWER] = 1;
        values[PID_LIMITHIGH] = 900;
        values[PID_LIMITLOW] = -900;
        values[PID_I_LIMITLOW] = -1e9f;
        values[PID_I_LIMITHIGH] = 1e9f;
    }

    /** Sets one of the numbers, such as PID_KP. */
    public void setPIDParam(int param, float value) {
        if (param < 0 || param >= COUNT) return;
        values[param] = value;
        if (param == PID_KI) sum = 0;
    }

    /** Gives one of the numbers, such as PID_KP. */
    public float getPIDParam(int param) {
        return param < 0 || param >= COUNT ? 0 : values[param];
    }

    /** Says whether the sum of errors is to stay as it is. */
    public void freezeIntegral(boolean freeze) {
        isFrozen = freeze;
    }

    /** Waits until it is time, and gives what to do about the value. */
    public int doPID(int processVariable) {
        if (delay > 0) {
            long now = System.currentTimeMillis();
            if (last != 0) Delay.msDelay(last + delay - now);
            last = System.currentTimeMillis();
        }
        int error = (int) values[PID_SETPOINT] - processVariable;
        if (Math.abs(error) <= values[PID_DEADBAND]) error = 0;
        if (!isFrozen) {
            sum += values[PID_KI] * error * (delay > 0 ? delay / 1000f : 1f);
            sum = Math.max(values[PID_I_LIMITLOW], Math.min(sum, values[PID_I_LIMITHIGH]));
        }
        float change = values[PID_KD] * (error - previousError) / (delay > 0 ? delay / 1000f : 1f);
        previousError = error;
        float output = values[PID_KP] * error + sum + change;
        output = Math.max(values[PID_LIMITLOW], Math.min(output, values[PID_LIMITHIGH]));
        return (int) ramp(output);
    }

    private float ramp(float output) {
        float threshold = values[PID_RAMP_THRESHOLD];
        if (threshold == 0 || values[PID_RAMP_POWER] == 0 || Math.abs(output) > threshold) return output;
        double part = Math.pow(Math.abs(output) / threshold, values[PID_RAMP_POWER]) * threshold;
        return (float) (output < 0 ? -part : part);
    }
}
