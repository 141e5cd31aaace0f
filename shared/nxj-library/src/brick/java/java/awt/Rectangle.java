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

    /** Makes an empty one at a point. */
    public Rectangle(Point p) {
        this(p.x, p.y, 0, 0);
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

    /** Gives its corner. */
    public Point getLocation() {
        return new Point(x, y);
    }

    /** Moves it. */
    public void setLocation(int x, int y) {
        this.x = x;
        this.y = y;
    }

    /** Moves it to a point. */
    public void setLocation(Point p) {
        setLocation(p.x, p.y);
    }

    /** Gives it another size. */
    public void setSize(int width, int height) {
        resize(width, height);
    }

    /** Gives it another size; an older name of setSize. */
    @Deprecated
    public void resize(int width, int height) {
        this.width = width;
        this.height = height;
    }

    /** Moves it and gives it another size. */
    public void setBounds(int x, int y, int width, int height) {
        reshape(x, y, width, height);
    }

    /** Makes it the same as another one. */
    public void setBounds(Rectangle r) {
        setBounds(r.x, r.y, r.width, r.height);
    }

    /** Moves it and gives it another size; an older name of setBounds. */
    @Deprecated
    public void reshape(int x, int y, int width, int height) {
        this.x = x;
        this.y = y;
        this.width = width;
        this.height = height;
    }

    /** Moves it and gives it another size, rounded so that nothing is cut off. */
    public void setRect(double x, double y, double w, double h) {
        boolean isTooFarRight = x > 2.0 * Integer.MAX_VALUE;
        boolean isTooFarDown = y > 2.0 * Integer.MAX_VALUE;
        int left = isTooFarRight ? Integer.MAX_VALUE : (int) Math.floor(x);
        int top = isTooFarDown ? Integer.MAX_VALUE : (int) Math.floor(y);
        reshape(left, top, isTooFarRight ? -1 : sizeOf(w, x - left), isTooFarDown ? -1 : sizeOf(h, y - top));
    }

    /** Gives a copy. */
    public Rectangle getBounds() {
        return new Rectangle(x, y, width, height);
    }

    /** Gives a copy. */
    public Rectangle2D getBounds2D() {
        return getBounds();
    }

    /** Says whether the point is inside. */
    public boolean contains(int x, int y) {
        return inside(x, y);
    }

    /** Says whether the point is inside. */
    public boolean contains(Point p) {
        return contains(p.x, p.y);
    }

    /** Says whether both corners of another one are inside; the right and lower sides are not. */
    public boolean contains(Rectangle r) {
        return !isEmpty() && !r.isEmpty() && contains(r.x, r.y) && contains(r.x + r.width, r.y + r.height);
    }

    /** Says whether the point is inside; an older name of contains. */
    @Deprecated
    public boolean inside(int x, int y) {
        if (width < 0 || height < 0 || x < this.x || y < this.y) return false;
        return isBelow(x, this.x, this.x + width) && isBelow(y, this.y, this.y + height);
    }

    /** Says whether a part of another one is inside. */
    public boolean intersects(Rectangle r) {
        if (isEmpty() || r.isEmpty()) return false;
        return isBelow(x, r.x, r.x + r.width) && isBelow(y, r.y, r.y + r.height)
            && isBelow(r.x, x, x + width) && isBelow(r.y, y, y + height);
    }

    /** Gives on which sides a point is outside, such as OUT_LEFT | OUT_TOP; 0 if it is inside. */
    public int outcode(double x, double y) {
        return new Double(this.x, this.y, width, height).outcode(x, y);
    }

    /** Says whether both are the same. */
    public boolean equals(Object other) {
        if (!(other instanceof Rectangle)) return super.equals(other);
        Rectangle r = (Rectangle) other;
        return x == r.x && y == r.y && width == r.width && height == r.height;
    }

    /** Gives its corner and its size as text. */
    public String toString() {
        return "Rectangle[x=" + x + ",y=" + y + ",width=" + width + ",height=" + height + "]";
    }

    /** The size in whole numbers of a side that begins so much behind the whole number. */
    private static int sizeOf(double size, double behind) {
        return size < 0 ? (int) Math.floor(size) : (int) Math.ceil(size + behind);
    }

    /** Whether a place is before the end of a side, which has none if it is too long for whole numbers. */
    private static boolean isBelow(int place, int start, int end) {
        return end < start || end > place;
    }
}
