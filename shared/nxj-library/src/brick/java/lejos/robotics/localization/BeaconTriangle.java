package lejos.robotics.localization;

import lejos.geom.Point;
import lejos.robotics.navigation.Pose;

/** Three beacons, from whose directions a robot can tell where it is. */
public class BeaconTriangle {
    final Point beacon1;
    final Point beacon2;
    final Point beacon3;

    /** Makes one of where the beacons are; they stand in this order for a robot that turns to the left. */
    public BeaconTriangle(Point beacon1, Point beacon2, Point beacon3) {
        this.beacon1 = beacon1;
        this.beacon2 = beacon2;
        this.beacon3 = beacon3;
    }

    /** Gives where a robot is that sees the beacons in these directions, in degrees to its left, 0 to 360. */
    public Pose calcPose(double a1, double a2, double a3) {
        double from1To2 = a1 > a2 ? 360 + (a2 - a1) : a2 - a1;
        double from3To1 = a3 > a1 ? 360 + (a1 - a3) : a1 - a3;
        double side12 = beacon1.distance(beacon2);
        double side31 = beacon3.distance(beacon1);
        double phi = halfTurn(beacon2.angleTo(beacon1));
        double direction2 = beacon1.angleTo(beacon2);
        double direction3 = beacon1.angleTo(beacon3);
        double sigma = halfTurn(180 - (direction3 - direction2));
        double gamma = sigma - from3To1;
        double above = sin(from1To2) * (side12 * sin(from3To1) - side31 * sin(gamma));
        double below = side31 * sin(from1To2) * cos(gamma) - side12 * cos(from1To2) * sin(from3To1);
        double tau = Math.toDegrees(Math.atan(above / below));
        if (from1To2 < 180 && tau < 0) tau += 180;
        if (from1To2 > 180 && tau > 0) tau -= 180;
        // As in leJOS NXJ, a sine is compared with degrees.
        double distance = Math.abs(sin(from1To2)) > Math.abs(from3To1) ? side12 * sin(tau + from1To2) / sin(from1To2)
            : side31 * sin(tau + sigma - from3To1) / sin(from3To1);
        double x = beacon1.x - distance * cos(phi + tau);
        double y = beacon1.y - distance * sin(phi + tau);
        double heading = phi + tau - a1;
        if (heading <= -180) heading += 360;
        if (heading > 180) heading -= 360;
        return new Pose((float) x, (float) y, (float) heading);
    }

    private static double halfTurn(double angle) {
        double result = angle;
        while (result <= -180) result += 360;
        while (result > 180) result -= 360;
        return result;
    }

    private static double sin(double degrees) {
        return Math.sin(Math.toRadians(degrees));
    }

    private static double cos(double degrees) {
        return Math.cos(Math.toRadians(degrees));
    }
}
