import lejos.nxt.*;
import lejos.robotics.navigation.DifferentialPilot;

/** All by myself. */
public class Bea {
    public static void main(String[] args) throws Exception {
        UltrasonicSensor ear = new UltrasonicSensor(SensorPort.S4);
        DifferentialPilot driver = new DifferentialPilot(5.6, 11.4, Motor.A, Motor.C);
        driver.setTravelSpeed(15);
        driver.forward();
        while (ear.getDistance() > 25) {
            Thread.sleep(20); // a little
        }
        driver.stop();
    }
}
