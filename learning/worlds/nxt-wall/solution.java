import lejos.nxt.Motor;
import lejos.nxt.SensorPort;
import lejos.nxt.UltrasonicSensor;
import lejos.robotics.navigation.DifferentialPilot;

/** Too near and not getting farther: a little away from the wall. Too far and not getting nearer: towards it. */
class Wall {
    static final int WANTED = 22;

    public static void main(String[] args) {
        UltrasonicSensor sonar = new UltrasonicSensor(SensorPort.S4);
        DifferentialPilot pilot = new DifferentialPilot(5.6, 11.4, Motor.A, Motor.C);
        int before = sonar.getDistance();
        while (true) {
            int now = sonar.getDistance();
            if (now < WANTED && now <= before) {
                pilot.rotate(6);
            } else if (now > WANTED && now >= before) {
                pilot.rotate(-6);
            }
            before = now;
            pilot.travel(4);
        }
    }
}
