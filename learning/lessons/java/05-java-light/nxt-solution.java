import lejos.nxt.*;
import lejos.robotics.navigation.DifferentialPilot;

public class Edge {
    public static void main(String[] args) throws InterruptedException {
        DifferentialPilot pilot = new DifferentialPilot(5.6, 11.4, Motor.A, Motor.C);
        LightSensor light = new LightSensor(SensorPort.S3);
        Thread.sleep(100);
        pilot.setTravelSpeed(20);
        pilot.forward();
        while (light.readValue() > 40) {
            Thread.sleep(5);
        }
        pilot.stop();
        Sound.beep();
        Thread.sleep(500);
    }
}
