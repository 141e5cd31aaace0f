package java.awt.geom;

import java.awt.Rectangle;
import java.awt.Shape;

/** A figure that fills a rectangle. */
public abstract class RectangularShape implements Shape, Cloneable {
    /** Makes one. */
    protected RectangularShape() {
    }

    /** Gives where its left side is. */
    public abstract double getX();

    /** Gives where its upper side is. */
    public abstract double getY();

    /** Gives how wide it is. */
    public abstract double getWidth();

    /** Gives how high it is. */
    public abstract double getHeight();

    /** Says whether it has no inside. */
    public abstract boolean isEmpty();

    /** Gives where its left side is. */
    public double getMinX() {
        return getX();
    }

    /** Gives where its upper side is. */
    public double getMinY() {
        return getY();
    }

    /** Gives where its right side is. */
    public double getMaxX() {
        return getX() + getWidth();
    }

    /** Gives where its lower side is. */
    public double getMaxY() {
        return getY() + getHeight();
    }

    /** Gives where its middle is, to the right. */
    public double getCenterX() {
        return getX() + getWidth() / 2;
    }

    /** Gives where its middle is, upward. */
    public double getCenterY() {
        return getY() + getHeight() / 2;
    }

    /** Says whether the point is inside. */
    public boolean contains(Point2D p) {
        return contains(p.getX(), p.getY());
    }

    /** Says whether the whole rectangle is inside. */
    public boolean contains(Rectangle2D r) {
        return contains(r.getX(), r.getY(), r.getWidth(), r.getHeight());
    }

    /** Says whether a part of the rectangle is inside. */
    public boolean intersects(Rectangle2D r) {
        return intersects(r.getX(), r.getY(), r.getWidth(), r.getHeight());
    }

    /** Gives the rectangle that it fills. */
    public Rectangle2D getFrame() {
        return new Rectangle2D.Double(getX(), getY(), getWidth(), getHeight());
    }

    /** Moves it and gives it another size. */
    public abstract void setFrame(double x, double y, double w, double h);

    /** Lets it fill a rectangle. */
    public void setFrame(Rectangle2D r) {
        setFrame(r.getX(), r.getY(), r.getWidth(), r.getHeight());
    }

    /** Gives a rectangle around it, in whole numbers. */
    public Rectangle getBounds() {
        if (getWidth() < 0 || getHeight() < 0) return new Rectangle();
        int left = (int) Math.floor(getX());
        int top = (int) Math.floor(getY());
        int right = (int) Math.ceil(getX() + getWidth());
        int bottom = (int) Math.ceil(getY() + getHeight());
        return new Rectangle(left, top, right - left, bottom - top);
    }

    /** Gives a copy. */
    public Object clone() {
        try {
            return super.clone();
        } catch (CloneNotSupportedException impossible) {
            throw new RuntimeException();
        }
    }
}
