package java.awt.geom;

/** A rectangle in the plane. */
public abstract class Rectangle2D extends RectangularShape {
    /** Makes one. */
    protected Rectangle2D() {
    }

    /** Moves it and gives it another size. */
    public abstract void setRect(double x, double y, double w, double h);

    /** Says whether the point is inside. */
    public boolean contains(double x, double y) {
        return x >= getX() && y >= getY() && x < getMaxX() && y < getMaxY();
    }

    /** Says whether the whole rectangle is inside. */
    public boolean contains(double x, double y, double w, double h) {
        return !isEmpty() && w > 0 && h > 0 && x >= getX() && y >= getY() && x + w <= getMaxX() && y + h <= getMaxY();
    }

    /** Says whether a part of the rectangle is inside. */
    public boolean intersects(double x, double y, double w, double h) {
        return !isEmpty() && w > 0 && h > 0 && x + w > getX() && y + h > getY() && x < getMaxX() && y < getMaxY();
    }

    /** Gives a copy. */
    public Rectangle2D getBounds2D() {
        return new Float((float) getX(), (float) getY(), (float) getWidth(), (float) getHeight());
    }

    /** A rectangle of float numbers. */
    public static class Float extends Rectangle2D {
        /** Where its left side is. */
        public float x;

        /** Where its upper side is. */
        public float y;

        /** How wide it is. */
        public float width;

        /** How high it is. */
        public float height;

        /** Makes an empty one at 0, 0. */
        public Float() {
        }

        /** Makes one of its corner and its size. */
        public Float(float x, float y, float width, float height) {
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

        /** Moves it and gives it another size. */
        public void setRect(double x, double y, double w, double h) {
            this.x = (float) x;
            this.y = (float) y;
            width = (float) w;
            height = (float) h;
        }
    }
}
