package lejos.robotics.localization;

import java.util.ArrayList;

/** Looks around for beacons. */
public interface BeaconLocator {
    /** Gives in which directions there are beacons, in degrees to the left of where the robot looks, 0 to 360. */
    ArrayList<Double> locate();
}
