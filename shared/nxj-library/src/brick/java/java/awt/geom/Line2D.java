package java.awt.geom;

import java.awt.Rectangle;
import java.awt.Shape;

/** A straight line between two points. */
public abstract class Line2D implements Shape, Cloneable {
    /** Makes one. */
    protected Line2D() {
    }

    /** Gives how far to the right the first point is. */
    public abstract double getX1();

    /** Gives how far up the first point is. */
    public abstract double getY1();

    /** Gives how far to the right the second point is. */
    public abstract double getX2();

    /** Gives how far up the second point is. */
    public abstract double getY2();

    /** Gives the first point. */
    public abstract Point2D getP1();

    /** Gives the second point. */
    public abstract Point2D getP2();

    /** Moves it. */
    public abstract void setLine(double x1, double y1, double x2, double y2);

    /** Moves it to other points. */
    public void setLine(Point2D p1, Point2D p2) {
        setLine(p1.getX(), p1.getY(), p2.getX(), p2.getY());
    }

    /** Makes it the same as another one. */
    public void setLine(Line2D other) {
        setLine(other.getX1(), other.getY1(), other.getX2(), other.getY2());
    }

    /** Says false: a line has no inside. */
    public boolean contains(double x, double y) {
        return false;
    }

    /** Says false: a line has no inside. */
    public boolean contains(Point2D p) {
        return false;
    }

    /** Says false: a line has no inside. */
    public boolean contains(double x, double y, double w, double h) {
        return false;
    }

    /** Says false: a line has no inside. */
    public boolean contains(Rectangle2D r) {
        return false;
    }

    /** Gives a rectangle around it, in whole numbers. */
    public Rectangle getBounds() {
        return getBounds2D().getBounds();
    }

    /** Says whether a part of the line is inside the rectangle. */
    public boolean intersects(double x, double y, double w, double h) {
        return intersects(new Rectangle2D.Double(x, y, w, h));
    }

    /** Says whether a part of the line is inside the rectangle. */
    public boolean intersects(Rectangle2D r) {
        return r.intersectsLine(getX1(), getY1(), getX2(), getY2());
    }

    /** Gives 1, -1 or 0: whether the point is to one side of the line, to the other one, or on it. */
    public static int relativeCCW(double x1, double y1, double x2, double y2, double px, double py) {
        double dx = x2 - x1;
        double dy = y2 - y1;
        double side = (px - x1) * dy - (py - y1) * dx;
        if (side == 0) {
            // On the straight line: before the first point, behind the second one, or between them.
            double along = (px - x1) * dx + (py - y1) * dy;
            if (along < 0) return -1;
            return along > dx * dx + dy * dy ? 1 : 0;
        }
        return side < 0 ? -1 : 1;
    }

    /** Says whether two lines meet. */
    public static boolean linesIntersect(double x1, double y1, double x2, double y2, double x3, double y3, double x4,
            double y4) {
        return relativeCCW(x1, y1, x2, y2, x3, y3) * relativeCCW(x1, y1, x2, y2, x4, y4) <= 0
            && relativeCCW(x3, y3, x4, y4, x1, y1) * relativeCCW(x3, y3, x4, y4, x2, y2) <= 0;
    }

    /** Gives the square of how far a point is from a line. */
    public static double ptSegDistSq(double x1, double y1, double x2, double y2, double px, double py) {
        double dx = x2 - x1;
        double dy = y2 - y1;
        double length = dx * dx + dy * dy;
        double part = length == 0 ? 0 : ((px - x1) * dx + (py - y1) * dy) / length;
        double near = part < 0 ? 0 : part > 1 ? 1 : part;
        return Point2D.distanceSq(x1 + near * dx, y1 + near * dy, px, py);
    }

    /** Gives how far a point is from a line. */
    public static double ptSegDist(double x1, double y1, double x2, double y2, double px, double py) {
        return Math.sqrt(ptSegDistSq(x1, y1, x2, y2, px, py));
    }

    /** Gives 1, -1 or 0: whether the point is to one side of this line, to the other one, or on it. */
    public int relativeCCW(double px, double py) {
        return relativeCCW(getX1(), getY1(), getX2(), getY2(), px, py);
    }

    /** Gives 1, -1 or 0: whether the point is to one side of this line, to the other one, or on it. */
    public int relativeCCW(Point2D p) {
        return relativeCCW(p.getX(), p.getY());
    }

    /** Says whether this line and another meet. */
    public boolean intersectsLine(double x1, double y1, double x2, double y2) {
        return linesIntersect(x1, y1, x2, y2, getX1(), getY1(), getX2(), getY2());
    }

    /** Says whether this line and another meet. */
    public boolean intersectsLine(Line2D other) {
        return intersectsLine(other.getX1(), other.getY1(), other.getX2(), other.getY2());
    }

    /** Gives the square of how far a point is from this line. */
    public double ptSegDistSq(double px, double py) {
        return ptSegDistSq(getX1(), getY1(), getX2(), getY2(), px, py);
    }

    /** Gives the square of how far a point is from this line. */
    public double ptSegDistSq(Point2D p) {
        return ptSegDistSq(p.getX(), p.getY());
    }

    /** Gives how far a point is from this line. */
    public double ptSegDist(double px, double py) {
        return ptSegDist(getX1(), getY1(), getX2(), getY2(), px, py);
    }

    /** Gives how far a point is from this line. */
    public double ptSegDist(Point2D p) {
        return ptSegDist(p.getX(), p.getY());
    }

    /** A line of float numbers. */
    public static class Float extends Line2D {
        /** How far to the right the first point is. */
        public float x1;

        /** How far up the first point is. */
        public float y1;

        /** How far to the right the second point is. */
        public float x2;

        /** How far up the second point is. */
        public float y2;

        /** Makes one from 0, 0 to 0, 0. */
        public Float() {
        }

        /** Makes one of two points. */
        public Float(float x1, float y1, float x2, float y2) {
            this.x1 = x1;
            this.y1 = y1;
            this.x2 = x2;
            this.y2 = y2;
        }

        /** Gives how far to the right the first point is. */
        public double getX1() {
            return x1;
        }

        /** Gives how far up the first point is. */
        public double getY1() {
            return y1;
        }

        /** Gives how far to the right the second point is. */
        public double getX2() {
            return x2;
        }

        /** Gives how far up the second point is. */
        public double getY2() {
            return y2;
        }

        /** Gives the first point. */
        public Point2D getP1() {
            return new Point2D.Float(x1, y1);
        }

        /** Gives the second point. */
        public Point2D getP2() {
            return new Point2D.Float(x2, y2);
        }

        /** Moves it. */
        public void setLine(double x1, double y1, double x2, double y2) {
            setLine((float) x1, (float) y1, (float) x2, (float) y2);
        }

        /** Moves it. */
        public void setLine(float x1, float y1, float x2, float y2) {
            this.x1 = x1;
            this.y1 = y1;
            this.x2 = x2;
            this.y2 = y2;
        }

        /** Gives a rectangle around it. */
        public Rectangle2D getBounds2D() {
            return new Rectangle2D.Float(Math.min(x1, x2), Math.min(y1, y2), Math.abs(x2 - x1), Math.abs(y2 - y1));
        }
    }

    /** A line of double numbers. */
    public static class Double extends Line2D {
        /** How far to the right the first point is. */
        public double x1;

        /** How far up the first point is. */
        public double y1;

        /** How far to the right the second point is. */
        public double x2;

        /** How far up the second point is. */
        public double y2;

        /** Makes one from 0, 0 to 0, 0. */
        public Double() {
        }

        /** Makes one of two points. */
        public Double(double x1, double y1, double x2, double y2) {
            this.x1 = x1;
            this.y1 = y1;
            this.x2 = x2;
            this.y2 = y2;
        }

        /** Gives how far to the right the first point is. */
        public double getX1() {
            return x1;
        }

        /** Gives how far up the first point is. */
        public double getY1() {
            return y1;
        }

        /** Gives how far to the right the second point is. */
        public double getX2() {
            return x2;
        }

        /** Gives how far up the second point is. */
        public double getY2() {
            return y2;
        }

        /** Gives the first point. */
        public Point2D getP1() {
            return new Point2D.Double(x1, y1);
        }

        /** Gives the second point. */
        public Point2D getP2() {
            return new Point2D.Double(x2, y2);
        }

        /** Moves it. */
        public void setLine(double x1, double y1, double x2, double y2) {
            this.x1 = x1;
            this.y1 = y1;
            this.x2 = x2;
            this.y2 = y2;
        }

        /** Gives a rectangle around it. */
        public Rectangle2D getBounds2D() {
            return new Rectangle2D.Double(Math.min(x1, x2), Math.min(y1, y2), Math.abs(x2 - x1), Math.abs(y2 - y1));
        }
    }
}
