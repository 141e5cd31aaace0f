package java.awt;

import java.awt.geom.Rectangle2D;

/** A rectangle in whole numbers. */
public class Rectangle extends Rectangle2D {
    /** Where its left side is. */
    public int x;

    /** Where its upper side is. */
    public int y;

    /** How wide it is. */
    public int width;

    /** How high it is. */
    public int height;

    /** Makes an empty one at 0, 0. */
    public Rectangle() {
        this(0, 0, 0, 0);
    }

    /** Makes one at 0, 0. */
    public Rectangle(int width, int height) {
        this(0, 0, width, height);
    }

    /** Makes one of its corner and its size. */
    public Rectangle(int x, int y, int width, int height) {
        this.x = x;
        this.y = y;
        this.width = width;
        this.height = height;
    }

    /** Gives where its left side is. */
    public double getX() {
        return x;
    }

    /** Gives where its upper side is. */
    public double getY() {
        return y;
    }

    /** Gives how wide it is. */
    public double getWidth() {
        return width;
    }

    /** Gives how high it is. */
    public double getHeight() {
        return height;
    }

    /** Says whether it has no inside. */
    public boolean isEmpty() {
        return width <= 0 || height <= 0;
    }

    /** Moves it and gives it another size, rounded so that nothing is cut off. */
    public void setRect(double x, double y, double w, double h) {
        this.x = (int) Math.floor(x);
        this.y = (int) Math.floor(y);
        width = (int) Math.ceil(x + w) - this.x;
        height = (int) Math.ceil(y + h) - this.y;
    }
}
