// Turns both wheels twice and shows what the motors have counted.
// Next: how far does the robot drive for one turn of its wheels?

import lejos.nxt.*;

public class CountDegrees {
    public static void main(String[] args) {
        Motor.A.setSpeed(360);
        Motor.C.setSpeed(360);
        // Both wheels turn twice. The first call goes on at once, the second one waits.
        Motor.A.rotate(720, true);
        Motor.C.rotate(720);
        Motor.A.waitComplete();
        LCD.drawString("Left  " + Motor.A.getTachoCount(), 0, 0);
        LCD.drawString("Right " + Motor.C.getTachoCount(), 0, 1);
        Button.waitForAnyPress(3000);
    }
}
