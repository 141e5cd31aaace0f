package josx.platform.rcx;

/** Is told when a sensor measures something new. */
public interface SensorListener {
    /** Is called when the value has changed; the first old value is 0. */
    void stateChanged(Sensor source, int oldValue, int newValue);
}
