import lejos.nxt.*;
import lejos.robotics.navigation.DifferentialPilot;

public class Feeler {
    public static void main(String[] args) throws InterruptedException {
        DifferentialPilot pilot = new DifferentialPilot(5.6, 11.4, Motor.A, Motor.C);
        TouchSensor left = new TouchSensor(SensorPort.S1);
        TouchSensor right = new TouchSensor(SensorPort.S2);
        pilot.forward();
        while (!left.isPressed() && !right.isPressed()) {
            Thread.sleep(5);
        }
        if (left.isPressed()) {
            pilot.travel(-5);
            pilot.rotate(-90);
        } else {
            pilot.travel(-5);
            pilot.rotate(90);
        }
        pilot.travel(25);
    }
}
