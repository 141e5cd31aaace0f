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
        double dx = (double) x2 - x1;
        double dy = (double) y2 - y1;
        double otherDx = (double) l.x2 - l.x1;
        double otherDy = (double) l.y2 - l.y1;
        double cross = dx * otherDy - dy * otherDx;
        if (cross == 0) return null;
        double part = ((l.x1 - x1) * otherDy - (l.y1 - y1) * otherDx) / cross;
        double otherPart = ((l.x1 - x1) * dy - (l.y1 - y1) * dx) / cross;
        if (part < 0 || part > 1 || otherPart < 0 || otherPart > 1) return null;
        return new Point((float) (x1 + part * dx), (float) (y1 + part * dy));
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
}
