package robotran.physics;

/** A node of a {@link BoundsTree}: a rectangle around its two children, or a {@link Leaf}. */
class TreeNode {
    double minX;
    double minY;
    double maxX;
    double maxY;
    TreeNode parent;

    /** Null in leaves. */
    TreeNode left;

    TreeNode right;

    /** The longest way to a leaf below; 0 in leaves. */
    int height;

    final boolean overlaps(TreeNode other) {
        return minX <= other.maxX && maxX >= other.minX && minY <= other.maxY && maxY >= other.minY;
    }

    final boolean contains(TreeNode other) {
        return minX <= other.minX && maxX >= other.maxX && minY <= other.minY && maxY >= other.maxY;
    }

    final double perimeter() {
        return perimeter(minX, minY, maxX, maxY);
    }

    /** The perimeter of the smallest rectangle around this one and another. */
    final double perimeterWith(TreeNode other) {
        if (contains(other)) {
            return perimeter();
        }
        return perimeter(
            lower(minX, other.minX),
            lower(minY, other.minY),
            higher(maxX, other.maxX),
            higher(maxY, other.maxY));
    }

    /** Updates it after a change of its children. Returns whether that has changed it. */
    final boolean update() {
        double oldMinX = minX;
        double oldMinY = minY;
        double oldMaxX = maxX;
        double oldMaxY = maxY;
        int oldHeight = height;
        height = 1 + Math.max(left.height, right.height);
        surround(left, right);
        return height != oldHeight
            || minX != oldMinX
            || minY != oldMinY
            || maxX != oldMaxX
            || maxY != oldMaxY;
    }

    /** Makes this the smallest rectangle around both. */
    final void surround(TreeNode one, TreeNode other) {
        minX = lower(one.minX, other.minX);
        minY = lower(one.minY, other.minY);
        maxX = higher(one.maxX, other.maxX);
        maxY = higher(one.maxY, other.maxY);
    }

    /** Like {@code Math.min}, except for what is not a number, but faster. */
    static double lower(double one, double other) {
        return one < other ? one : other;
    }

    static double higher(double one, double other) {
        return one > other ? one : other;
    }

    static double perimeter(double minX, double minY, double maxX, double maxY) {
        return 2 * (maxX - minX + maxY - minY);
    }
}
