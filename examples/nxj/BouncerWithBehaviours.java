// The wall bouncer with behaviours: Drive just drives, and Avoid takes over while a bumper is pressed.
// Next: a third behaviour that beeps when the ultrasonic sensor sees something near.

import lejos.nxt.*;
import lejos.robotics.navigation.DifferentialPilot;
import lejos.robotics.subsumption.Arbitrator;
import lejos.robotics.subsumption.Behavior;

public class BouncerWithBehaviours {
    static final DifferentialPilot PILOT = new DifferentialPilot(5.6, 11.4, Motor.A, Motor.C);
    static final TouchSensor LEFT = new TouchSensor(SensorPort.S1);
    static final TouchSensor RIGHT = new TouchSensor(SensorPort.S2);

    static class Drive implements Behavior {
        private boolean suppressed;

        public boolean takeControl() {
            return true;
        }

        public void action() {
            suppressed = false;
            PILOT.forward();
            while (!suppressed) Thread.yield();
            PILOT.stop();
        }

        public void suppress() {
            suppressed = true;
        }
    }

    static class Avoid implements Behavior {
        public boolean takeControl() {
            return LEFT.isPressed() || RIGHT.isPressed();
        }

        public void action() {
            PILOT.travel(-10);
            PILOT.rotate(120);
        }

        public void suppress() {
        }
    }

    public static void main(String[] args) {
        PILOT.setTravelSpeed(20);
        Behavior[] behaviours = { new Drive(), new Avoid() };
        new Arbitrator(behaviours).start();
    }
}
