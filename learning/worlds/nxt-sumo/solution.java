import lejos.nxt.LightSensor;
import lejos.nxt.Motor;
import lejos.nxt.SensorPort;
import lejos.nxt.UltrasonicSensor;
import lejos.robotics.navigation.DifferentialPilot;

/** Turns until the sonar hears something in the ring, and pushes it. At the black edge it goes back and looks again. */
class Sumo {
    static final int NEAR = 60;
    static final int BORDER = 45; // darker is the edge

    public static void main(String[] args) throws InterruptedException {
        LightSensor light = new LightSensor(SensorPort.S3);
        UltrasonicSensor sonar = new UltrasonicSensor(SensorPort.S4);
        DifferentialPilot pilot = new DifferentialPilot(5.6, 14, Motor.A, Motor.C);
        pilot.setAcceleration(300);
        while (true) {
            pilot.setRotateSpeed(90);
            pilot.rotateLeft();
            while (sonar.getDistance() >= NEAR) {
                Thread.sleep(5);
            }
            pilot.setTravelSpeed(35);
            pilot.forward();
            while (light.getLightValue() >= BORDER) {
                Thread.sleep(5);
            }
            pilot.stop();
            pilot.setTravelSpeed(17);
            pilot.travel(-20);
        }
    }
}
