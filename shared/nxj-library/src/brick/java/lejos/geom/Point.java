package lejos.geom;

import java.awt.geom.Point2D;

/** A point in the plane, or a way from one point to another. */
public class Point extends Point2D.Float {
    /** Makes a point. */
    public Point(float x, float y) {
        super(x, y);
    }

    /** Makes a way of length 1 in a direction in radians. */
    public Point(float radians) {
        this((float) Math.cos(radians), (float) Math.sin(radians));
    }

    /** Gives the point that is a way further. */
    public Point add(Point other) {
        return new Point(x + other.x, y + other.y);
    }

    /** Moves this point by a way, and gives it. */
    public Point addWith(Point other) {
        x += other.x;
        y += other.y;
        return this;
    }

    /** Gives the way from the other point to this one. */
    public Point subtract(Point other) {
        return new Point(x - other.x, y - other.y);
    }

    /** Moves this point back by a way, and gives it. */
    public Point subtractWith(Point other) {
        x -= other.x;
        y -= other.y;
        return this;
    }

    /** Gives the way so many times. */
    public Point multiply(float factor) {
        return new Point(x * factor, y * factor);
    }

    /** Gives the way turned by a quarter to the left. */
    public Point leftOrth() {
        return new Point(-y, x);
    }

    /** Gives the way turned by a quarter to the right. */
    public Point rightOrth() {
        return new Point(y, -x);
    }

    /** Gives the dot product of two ways. */
    public float dotProduct(Point other) {
        return x * other.x + y * other.y;
    }

    /** Gives how long the way is. */
    public float length() {
        return (float) Math.sqrt(dotProduct(this));
    }

    /** Gives the direction of the way in radians. */
    public float angle() {
        return (float) Math.atan2(y, x);
    }

    /** Gives the direction to another point in degrees. */
    public float angleTo(Point other) {
        return (float) Math.toDegrees(Math.atan2(other.y - y, other.x - x));
    }

    /** Gives the point that is so far away in a direction in degrees. */
    public Point pointAt(float distance, float angle) {
        double radians = Math.toRadians(angle);
        return new Point(x + distance * (float) Math.cos(radians), y + distance * (float) Math.sin(radians));
    }

    /** Moves this point by so much. */
    public void translate(float dx, float dy) {
        x += dx;
        y += dy;
    }

    /** Makes another point the same as this one, and gives that. */
    public Point copyTo(Point other) {
        other.x = x;
        other.y = y;
        return other;
    }

    /** Makes this point the same as another one. */
    public void moveTo(Point other) {
        x = other.x;
        y = other.y;
    }

    /** Gives a copy. */
    public Point clone() {
        return new Point(x, y);
    }

    /** Gives the way shortened by so much. */
    public Point subtract(float length) {
        return subtract(getNormalized().multiply(length));
    }

    /** Makes this way so many times as long, and gives it. */
    public Point multiplyBy(float factor) {
        x *= factor;
        y *= factor;
        return this;
    }

    /** Gives the way with the length 1. */
    public Point getNormalized() {
        return new Point(x / length(), y / length());
    }

    /** Gives this way the length 1, and gives it. */
    public Point normalize() {
        float length = length();
        x /= length;
        y /= length;
        return this;
    }

    /** Gives the way in the opposite direction. */
    public Point reverse() {
        return multiply(-1f);
    }

    /** Turns this way by a quarter to the left, and gives it. */
    public Point makeLeftOrth() {
        float before = x;
        x = -y;
        y = before;
        return this;
    }

    /** Turns this way by a quarter to the right, and gives it. */
    public Point makeRightOrth() {
        float before = x;
        x = y;
        y = -before;
        return this;
    }

    /** Gives the point of a line, or of its extension, that is nearest to this one. */
    public Point projectOn(Line line) {
        Point start = line.getP1();
        Point along = line.getP2().subtract(start);
        float part = subtract(start).dotProduct(along) / along.dotProduct(along);
        return along.multiply(part).add(start);
    }
}
