// Follows the left edge of a dark line: the farther from it, the more it turns.
// Next: try other figures for TURN. What happens with 2, and with 30?

import lejos.nxt.*;

public class LineFollower {
    static final int EDGE = 45;
    static final int SPEED = 240;
    static final int TURN = 8;

    public static void main(String[] args) {
        LightSensor light = new LightSensor(SensorPort.S3);
        while (!Button.ESCAPE.isDown()) {
            int error = light.readValue() - EDGE;
            Motor.A.setSpeed(Math.max(0, SPEED + TURN * error));
            Motor.C.setSpeed(Math.max(0, SPEED - TURN * error));
            Motor.A.forward();
            Motor.C.forward();
        }
    }
}
