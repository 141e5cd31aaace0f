package lejos.nxt;

import lejos.robotics.Touch;

/** A sensor that feels whether something presses it. */
public class TouchSensor implements SensorConstants, Touch {
    private final ADSensorPort port;

    /** Makes the sensor of a port. */
    public TouchSensor(ADSensorPort port) {
        this.port = port;
        port.setTypeAndMode(TYPE_SWITCH, MODE_BOOLEAN);
    }

    /** Says whether something presses it. */
    public boolean isPressed() {
        return port.readBooleanValue();
    }
}
