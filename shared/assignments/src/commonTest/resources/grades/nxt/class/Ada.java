import lejos.nxt.Motor;
import lejos.nxt.SensorPort;
import lejos.nxt.UltrasonicSensor;
import lejos.robotics.navigation.DifferentialPilot;

public class Ada {
    public static void main(String[] args) throws Exception {
        UltrasonicSensor sonar = new UltrasonicSensor(SensorPort.S4);
        DifferentialPilot pilot = new DifferentialPilot(5.6, 11.4, Motor.A, Motor.C);
        pilot.setTravelSpeed(15);
        pilot.forward();
        while (sonar.getDistance() > 25) {
            Thread.sleep(20);
        }
        pilot.stop();
        System.out.println("at " + sonar.getDistance());
    }
}
