package java.awt.geom;

/** A rectangle in the plane. */
public abstract class Rectangle2D extends RectangularShape {
    /** The point is left of the rectangle. */
    public static final int OUT_LEFT = 1;

    /** The point is above the rectangle. */
    public static final int OUT_TOP = 2;

    /** The point is right of the rectangle. */
    public static final int OUT_RIGHT = 4;

    /** The point is below the rectangle. */
    public static final int OUT_BOTTOM = 8;

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

    /** Makes it the same as another one. */
    public void setRect(Rectangle2D r) {
        setRect(r.getX(), r.getY(), r.getWidth(), r.getHeight());
    }

    /** Moves it and gives it another size. */
    public void setFrame(double x, double y, double w, double h) {
        setRect(x, y, w, h);
    }

    /** Gives on which sides a point is outside, such as OUT_LEFT | OUT_TOP; 0 if it is inside. */
    public abstract int outcode(double x, double y);

    /** Gives on which sides a point is outside, such as OUT_LEFT | OUT_TOP; 0 if it is inside. */
    public int outcode(Point2D p) {
        return outcode(p.getX(), p.getY());
    }

    /** Says whether a part of a line is inside. */
    public boolean intersectsLine(double x1, double y1, double x2, double y2) {
        double x = x1;
        double y = y1;
        int end = outcode(x2, y2);
        if (end == 0) return true;
        for (int out = outcode(x, y); out != 0; out = outcode(x, y)) {
            if ((out & end) != 0) return false;
            // Goes on to where the line crosses the side that it is outside of.
            if ((out & (OUT_LEFT | OUT_RIGHT)) != 0) {
                double side = (out & OUT_RIGHT) != 0 ? getX() + getWidth() : getX();
                y += (side - x) * (y2 - y) / (x2 - x);
                x = side;
            } else {
                double side = (out & OUT_BOTTOM) != 0 ? getY() + getHeight() : getY();
                x += (side - y) * (x2 - x) / (y2 - y);
                y = side;
            }
        }
        return true;
    }

    /** Says whether both are the same rectangle. */
    public boolean equals(Object other) {
        if (!(other instanceof Rectangle2D)) return false;
        Rectangle2D r = (Rectangle2D) other;
        return getX() == r.getX() && getY() == r.getY() && getWidth() == r.getWidth() && getHeight() == r.getHeight();
    }

    /** On which sides a place is outside, from the start of a side and its length. */
    static int outcode(double place, double start, double length, int before, int behind) {
        if (length <= 0) return before | behind;
        return place < start ? before : place > start + length ? behind : 0;
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
            setRect((float) x, (float) y, (float) w, (float) h);
        }

        /** Moves it and gives it another size. */
        public void setRect(float x, float y, float w, float h) {
            this.x = x;
            this.y = y;
            width = w;
            height = h;
        }

        /** Makes it the same as another one. */
        public void setRect(Rectangle2D r) {
            setRect(r.getX(), r.getY(), r.getWidth(), r.getHeight());
        }

        /** Gives on which sides a point is outside, such as OUT_LEFT | OUT_TOP; 0 if it is inside. */
        public int outcode(double x, double y) {
            return outcode(x, this.x, width, OUT_LEFT, OUT_RIGHT) | outcode(y, this.y, height, OUT_TOP, OUT_BOTTOM);
        }

        /** Gives a copy. */
        public Rectangle2D getBounds2D() {
            return new Float(x, y, width, height);
        }
    }

    /** A rectangle of double numbers. */
    public static class Double extends Rectangle2D {
        /** Where its left side is. */
        public double x;

        /** Where its upper side is. */
        public double y;

        /** How wide it is. */
        public double width;

        /** How high it is. */
        public double height;

        /** Makes an empty one at 0, 0. */
        public Double() {
        }

        /** Makes one of its corner and its size. */
        public Double(double x, double y, double width, double height) {
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
            this.x = x;
            this.y = y;
            width = w;
            height = h;
        }

        /** Makes it the same as another one. */
        public void setRect(Rectangle2D r) {
            setRect(r.getX(), r.getY(), r.getWidth(), r.getHeight());
        }

        /** Gives on which sides a point is outside, such as OUT_LEFT | OUT_TOP; 0 if it is inside. */
        public int outcode(double x, double y) {
            return outcode(x, this.x, width, OUT_LEFT, OUT_RIGHT) | outcode(y, this.y, height, OUT_TOP, OUT_BOTTOM);
        }

        /** Gives a copy. */
        public Rectangle2D getBounds2D() {
            return new Double(x, y, width, height);
        }
    }
}
