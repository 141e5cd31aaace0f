package java.awt.geom;

/** A point in the plane. */
public abstract class Point2D implements Cloneable {
    /** Makes one. */
    protected Point2D() {
    }

    /** Gives how far to the right it is. */
    public abstract double getX();

    /** Gives how far up it is. */
    public abstract double getY();

    /** Moves it to another place. */
    public abstract void setLocation(double x, double y);

    /** Moves it to another place. */
    public void setLocation(Point2D p) {
        setLocation(p.getX(), p.getY());
    }

    /** Gives how far two points are apart. */
    public static double distance(double x1, double y1, double x2, double y2) {
        return Math.sqrt(distanceSq(x1, y1, x2, y2));
    }

    /** Gives the square of how far two points are apart. */
    public static double distanceSq(double x1, double y1, double x2, double y2) {
        return (x2 - x1) * (x2 - x1) + (y2 - y1) * (y2 - y1);
    }

    /** Gives how far away a point is. */
    public double distance(double px, double py) {
        return distance(getX(), getY(), px, py);
    }

    /** Gives how far away a point is. */
    public double distance(Point2D p) {
        return distance(p.getX(), p.getY());
    }

    /** Gives the square of how far away a point is. */
    public double distanceSq(double px, double py) {
        return distanceSq(getX(), getY(), px, py);
    }

    /** Gives the square of how far away a point is. */
    public double distanceSq(Point2D p) {
        return distanceSq(p.getX(), p.getY());
    }

    /** Says whether both are the same place. */
    public boolean equals(Object other) {
        if (!(other instanceof Point2D)) return false;
        Point2D point = (Point2D) other;
        return getX() == point.getX() && getY() == point.getY();
    }

    /** A point of float numbers. */
    public static class Float extends Point2D {
        /** How far to the right it is. */
        public float x;

        /** How far up it is. */
        public float y;

        /** Makes the point 0, 0. */
        public Float() {
        }

        /** Makes a point. */
        public Float(float x, float y) {
            this.x = x;
            this.y = y;
        }

        /** Gives how far to the right it is. */
        public double getX() {
            return x;
        }

        /** Gives how far up it is. */
        public double getY() {
            return y;
        }

        /** Moves it to another place. */
        public void setLocation(double x, double y) {
            this.x = (float) x;
            this.y = (float) y;
        }

        /** Moves it to another place. */
        public void setLocation(float x, float y) {
            this.x = x;
            this.y = y;
        }

        /** Gives the point as text. */
        public String toString() {
            return "Point2D.Float[" + x + ", " + y + "]";
        }
    }

    /** A point of double numbers. */
    public static class Double extends Point2D {
        /** How far to the right it is. */
        public double x;

        /** How far up it is. */
        public double y;

        /** Makes the point 0, 0. */
        public Double() {
        }

        /** Makes a point. */
        public Double(double x, double y) {
            this.x = x;
            this.y = y;
        }

        /** Gives how far to the right it is. */
        public double getX() {
            return x;
        }

        /** Gives how far up it is. */
        public double getY() {
            return y;
        }

        /** Moves it to another place. */
        public void setLocation(double x, double y) {
            this.x = x;
            this.y = y;
        }

        /** Gives the point as text. */
        public String toString() {
            return "Point2D.Double[" + x + ", " + y + "]";
        }
    }
}
