import lejos.nxt.ColorSensor;
import lejos.nxt.LCD;
import lejos.nxt.Motor;
import lejos.nxt.SensorPort;
import lejos.robotics.Color;

/** Counts the red lines. Between two lines it waits until it sees the white paper. */
class Lines {
    static final ColorSensor EYE = new ColorSensor(SensorPort.S2);

    public static void main(String[] args) throws InterruptedException {
        Motor.A.setSpeed(240);
        Motor.C.setSpeed(240);
        Motor.A.forward();
        Motor.C.forward();
        for (int lines = 1; lines <= 3; lines++) {
            waitFor(Color.RED);
            LCD.drawInt(lines, 0, 0);
            waitFor(Color.WHITE);
        }
        Motor.A.stop(true);
        Motor.C.stop();
        Thread.sleep(300); // until the display has shown it
    }

    static void waitFor(int colour) throws InterruptedException {
        while (EYE.getColorID() != colour) {
            Thread.sleep(5);
        }
    }
}
