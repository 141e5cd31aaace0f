import lejos.nxt.LCD;
import lejos.nxt.Motor;
import lejos.nxt.SensorPort;
import lejos.nxt.UltrasonicSensor;
import lejos.robotics.navigation.DifferentialPilot;

/** Measures how far it drives while the sonar hears no box: so wide is the gap. */
class Park {
    static final int NEAR = 35;
    static final int EARLY = 6; // the sonar hears a box so many centimetres before and after it is there
    static final UltrasonicSensor SONAR = new UltrasonicSensor(SensorPort.S4);

    public static void main(String[] args) throws InterruptedException {
        DifferentialPilot pilot = new DifferentialPilot(5.6, 11.4, Motor.A, Motor.C);
        pilot.setTravelSpeed(11);
        pilot.forward();
        float width = 0;
        while (width < 30) {
            waitForGap(true);
            float begin = pilot.getMovementIncrement();
            waitForGap(false);
            width = pilot.getMovementIncrement() - begin + 2 * EARLY;
            LCD.drawInt(Math.round(width), 4, 0, 0);
        }
        pilot.stop();
        pilot.travel(EARLY + 2 - width / 2); // the sonar is 2 cm ahead
        pilot.rotate(-90);
        pilot.travel(30);
    }

    static void waitForGap(boolean isThere) throws InterruptedException {
        while (SONAR.getDistance() > NEAR != isThere) {
            Thread.sleep(5);
        }
    }
}
