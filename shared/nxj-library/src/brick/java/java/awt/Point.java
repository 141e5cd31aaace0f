package java.awt;

import java.awt.geom.Point2D;

/** A point in whole numbers. */
public class Point extends Point2D {
    /** How far to the right it is. */
    public int x;

    /** How far up it is. */
    public int y;

    /** Makes the point 0, 0. */
    public Point() {
        this(0, 0);
    }

    /** Makes a point. */
    public Point(int x, int y) {
        this.x = x;
        this.y = y;
    }

    /** Makes a copy of a point. */
    public Point(Point p) {
        this(p.x, p.y);
    }

    /** Gives how far to the right it is. */
    public double getX() {
        return x;
    }

    /** Gives how far up it is. */
    public double getY() {
        return y;
    }

    /** Gives a copy. */
    public Point getLocation() {
        return new Point(this);
    }

    /** Moves it to another place. */
    public void setLocation(Point p) {
        setLocation(p.x, p.y);
    }

    /** Moves it to another place. */
    public void setLocation(int x, int y) {
        move(x, y);
    }

    /** Moves it to another place, rounded. */
    public void setLocation(double x, double y) {
        move((int) Math.floor(x + 0.5), (int) Math.floor(y + 0.5));
    }

    /** Moves it to another place. */
    public void move(int x, int y) {
        this.x = x;
        this.y = y;
    }

    /** Moves it by so much. */
    public void translate(int dx, int dy) {
        move(x + dx, y + dy);
    }

    /** Gives the point as text. */
    public String toString() {
        return "Point[x=" + x + ",y=" + y + "]";
    }
}
