package lejos.geom;

import java.awt.geom.Line2D;

/** A straight line between two points. */
public class Line extends Line2D.Float {
    /** Makes one of two points. */
    public Line(float x1, float y1, float x2, float y2) {
        super(x1, y1, x2, y2);
    }

    /** Gives where this line and another meet, or null. */
    public Point intersectsAt(Line l) {
        // A brick calculates with float numbers: along x if a line is level, and otherwise along y.
        boolean isLevel = y1 == y2;
        boolean isOtherLevel = l.y1 == l.y2;
        boolean isUpright = x1 == x2;
        boolean isOtherUpright = l.x1 == l.x2;
        if (isLevel && isOtherLevel || isUpright && isOtherUpright) return null;
        if (isUpright && isOtherLevel) return onBoth(l, x1, l.y1);
        if (isLevel && isOtherUpright) return onBoth(l, l.x1, y1);
        if (isLevel || isOtherLevel) {
            float slope = (y2 - y1) / (x2 - x1);
            float start = y1 - slope * x1;
            float otherSlope = (l.y2 - l.y1) / (l.x2 - l.x1);
            if (slope == otherSlope) return null;
            float x = (l.y1 - otherSlope * l.x1 - start) / (slope - otherSlope);
            return onBoth(l, x, slope * x + start);
        }
        float slope = (x2 - x1) / (y2 - y1);
        float start = x1 - slope * y1;
        float otherSlope = (l.x2 - l.x1) / (l.y2 - l.y1);
        if (slope == otherSlope) return null;
        float y = (l.x1 - otherSlope * l.y1 - start) / (slope - otherSlope);
        return onBoth(l, slope * y + start, y);
    }

    /** Gives how far this line and another are apart. */
    public double segDist(Line seg) {
        if (intersectsLine(seg)) return 0;
        double own = Math.min(ptSegDist(seg.x1, seg.y1), ptSegDist(seg.x2, seg.y2));
        return Math.min(own, Math.min(seg.ptSegDist(x1, y1), seg.ptSegDist(x2, y2)));
    }

    /** Makes the line longer by so much at both ends. */
    public void lengthen(float delta) {
        double angle = Math.atan2(y2 - y1, x2 - x1);
        float dx = delta * (float) Math.cos(angle);
        float dy = delta * (float) Math.sin(angle);
        x1 -= dx;
        y1 -= dy;
        x2 += dx;
        y2 += dy;
    }

    /** Gives how long the line is. */
    public float length() {
        return (float) Math.sqrt((x2 - x1) * (x2 - x1) + (y2 - y1) * (y2 - y1));
    }

    /** Gives the first point. */
    public Point getP1() {
        return new Point(x1, y1);
    }

    /** Gives the second point. */
    public Point getP2() {
        return new Point(x2, y2);
    }

    private Point onBoth(Line l, float x, float y) {
        boolean isOnBoth = isBetween(x, x1, x2) && isBetween(y, y1, y2) && isBetween(x, l.x1, l.x2)
            && isBetween(y, l.y1, l.y2);
        return isOnBoth ? new Point(x, y) : null;
    }

    private static boolean isBetween(float value, float a, float b) {
        return a <= b ? value >= a && value <= b : value >= b && value <= a;
    }
}
