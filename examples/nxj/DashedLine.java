// Draws a dashed line: pen down, pen up, and so on.
// Next: let the dashes become longer and longer.

import lejos.nxt.*;
import lejos.robotics.navigation.DifferentialPilot;

public class DashedLine {
    static final int PEN_DOWN = 85;
    static final int PEN_UP = 0;

    public static void main(String[] args) {
        DifferentialPilot pilot = new DifferentialPilot(5.6, 11.4, Motor.A, Motor.C);
        pilot.setTravelSpeed(15);
        for (int dash = 0; dash < 6; dash++) {
            Motor.B.rotateTo(PEN_DOWN);
            pilot.travel(4);
            Motor.B.rotateTo(PEN_UP);
            pilot.travel(2);
        }
    }
}
