package java.awt;

import java.awt.geom.Point2D;
import java.awt.geom.Rectangle2D;

/** A figure in the plane. */
public interface Shape {
    /** Says whether the point is inside. */
    boolean contains(double x, double y);

    /** Says whether the point is inside. */
    boolean contains(Point2D p);

    /** Says whether the whole rectangle is inside. */
    boolean contains(double x, double y, double w, double h);

    /** Says whether the whole rectangle is inside. */
    boolean contains(Rectangle2D r);

    /** Gives a rectangle around it, in whole numbers. */
    Rectangle getBounds();

    /** Gives a rectangle around it. */
    Rectangle2D getBounds2D();

    /** Says whether a part of the rectangle is inside. */
    boolean intersects(double x, double y, double w, double h);

    /** Says whether a part of the rectangle is inside. */
    boolean intersects(Rectangle2D r);
}
