import lejos.nxt.Button;
import lejos.nxt.LCD;
import lejos.nxt.SensorPort;
import lejos.nxt.TouchSensor;

// button LEFT at 500: pressed
// button LEFT at 600: released
// sensor 1 at 1000: raw 183
// button ESCAPE at 1500: pressed
// button ESCAPE at 1600: released
// screen 0: press
// screen 1: left
// screen 2: bump
// ends at 1570
/** Buttons and a touch sensor. */
public class Pressed {
    public static void main(String[] args) throws Exception {
        TouchSensor bumper = new TouchSensor(SensorPort.S1);
        LCD.drawString("press", 0, 0);
        Button.LEFT.waitForPressAndRelease();
        LCD.drawString("left", 0, 1);
        while (!bumper.isPressed()) Thread.yield();
        LCD.drawString("bump", 0, 2);
        while (Button.waitForAnyPress() != Button.ID_ESCAPE) Thread.yield();
        LCD.refresh();
        Thread.sleep(10);
    }
}
