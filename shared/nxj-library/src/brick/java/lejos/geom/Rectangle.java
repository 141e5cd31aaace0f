package lejos.geom;

import java.awt.geom.Rectangle2D;

/** A rectangle in the plane. */
public class Rectangle extends Rectangle2D.Float {
    /** Makes one of its corner and its size. */
    public Rectangle(float x, float y, float width, float height) {
        super(x, y, width, height);
    }
}
