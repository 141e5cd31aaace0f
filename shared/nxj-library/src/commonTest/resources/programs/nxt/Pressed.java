import lejos.nxt.Button;
import lejos.nxt.LCD;
import lejos.nxt.SensorPort;
import lejos.nxt.TouchSensor;

/** Buttons and a touch sensor. */
public class Pressed { // press LEFT at 500
    public static void main(String[] args) throws Exception { // press ESCAPE at 1500
        TouchSensor bumper = new TouchSensor(SensorPort.S1); // sensor 1 at 0: raw 1023
        LCD.drawString("press", 0, 0); // screen press
        Button.LEFT.waitForPressAndRelease(); // sensor 1 at 1000: raw 183
        LCD.drawString("left", 0, 1); // screen left
        while (!bumper.isPressed()) Thread.yield();
        LCD.drawString("bump", 0, 2); // screen bump
        while (Button.waitForAnyPress() != Button.ID_ESCAPE) Thread.yield();
        LCD.refresh();
        Thread.sleep(10); // takes 1570
    }
}
