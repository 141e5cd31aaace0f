// Drives ahead until the ultrasonic sensor sees a wall 20 cm away.
// Next: let it drive slower the nearer it comes.

import lejos.nxt.*;
import lejos.robotics.navigation.DifferentialPilot;
import lejos.util.Delay;

public class StopAtWall {
    public static void main(String[] args) {
        UltrasonicSensor sonar = new UltrasonicSensor(SensorPort.S4);
        DifferentialPilot pilot = new DifferentialPilot(5.6, 11.4, Motor.A, Motor.C);
        pilot.setTravelSpeed(15);
        pilot.forward();
        int distance = sonar.getDistance();
        while (distance > 20) {
            LCD.clear(0);
            LCD.drawString("Distance " + distance, 0, 0);
            Delay.msDelay(50);
            distance = sonar.getDistance();
        }
        pilot.stop();
        LCD.drawString("Stopped at " + distance, 0, 1);
        Sound.twoBeeps();
        Delay.msDelay(1000);
    }
}
