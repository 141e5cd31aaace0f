// Visits three places with a navigator.
// Next: draw the way: let the pen down first.

import lejos.nxt.*;
import lejos.robotics.navigation.DifferentialPilot;
import lejos.robotics.navigation.Navigator;

public class Journey {
    public static void main(String[] args) {
        DifferentialPilot pilot = new DifferentialPilot(5.6, 11.4, Motor.A, Motor.C);
        pilot.setTravelSpeed(15);
        pilot.setRotateSpeed(90);
        Navigator navigator = new Navigator(pilot);
        navigator.addWaypoint(30, 0);
        navigator.addWaypoint(30, 20);
        navigator.addWaypoint(0, 0);
        navigator.followPath();
        navigator.waitForStop();
        Sound.beepSequence();
    }
}
