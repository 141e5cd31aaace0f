package robotran.physics;

/**
 * A balanced tree of rectangles that finds overlapping ones. Its shape, and so the order in which it finds them, is
 * always that of dyn4j's {@code DynamicAABBTree} after the same calls, because the order of contacts affects results.
 * But nothing is looked up in hash maps here.
 */
final class BoundsTree {
    private TreeNode root;

    /** The node at the top, null in an empty tree. Visit nodes with {@link #after}, left children first. */
    TreeNode root() {
        return root;
    }

    /** The node to visit after {@code node} and everything below it, or null. */
    static TreeNode after(TreeNode node) {
        TreeNode last = node;
        while (last.parent != null) {
            if (last == last.parent.left) {
                return last.parent.right;
            }
            last = last.parent;
        }
        return null;
    }

    void insert(Leaf leaf) {
        if (root == null) {
            root = leaf;
            return;
        }
        TreeNode sibling = siblingFor(leaf);
        TreeNode joint = new TreeNode();
        joint.surround(sibling, leaf);
        joint.height = sibling.height + 1;
        replace(sibling, joint);
        joint.left = sibling;
        joint.right = leaf;
        sibling.parent = joint;
        leaf.parent = joint;
        balanceFrom(joint);
    }

    void remove(Leaf leaf) {
        if (leaf == root) {
            root = null;
            return;
        }
        TreeNode joint = leaf.parent;
        replace(joint, joint.left == leaf ? joint.right : joint.left);
        balanceFrom(joint.parent);
    }

    /** The node beside which a leaf lengthens the perimeters of the tree the least, as far as seen from above. */
    private TreeNode siblingFor(Leaf leaf) {
        TreeNode node = root;
        while (node.left != null) {
            double together = node.perimeterWith(leaf);
            double cost = 2 * together;
            double costBelow = 2 * (together - node.perimeter());
            double costLeft = costBelow(node.left, leaf, costBelow);
            double costRight = costBelow(node.right, leaf, costBelow);
            if (cost < costLeft && cost < costRight) {
                break;
            }
            node = costLeft < costRight ? node.left : node.right;
        }
        return node;
    }

    private static double costBelow(TreeNode node, Leaf leaf, double costAbove) {
        double together = node.perimeterWith(leaf);
        return (node.left == null ? together : together - node.perimeter()) + costAbove;
    }

    /** Puts {@code next} into the place of {@code node}. */
    private void replace(TreeNode node, TreeNode next) {
        TreeNode parent = node.parent;
        next.parent = parent;
        if (parent == null) {
            root = next;
        } else if (parent.left == node) {
            parent.left = next;
        } else {
            parent.right = next;
        }
    }

    /** Updates a node whose children have changed, and everything above it. */
    private void balanceFrom(TreeNode lowest) {
        TreeNode node = lowest;
        boolean isOld = true;
        while (node != null) {
            TreeNode before = node;
            node = balanced(before);
            // Where nothing has changed, nothing changes above, except that a node may still have to be rotated.
            if (isOld || node != before) {
                isOld = node.update() || node != before || before == lowest;
            }
            node = node.parent;
        }
    }

    /** Rotates a node whose children differ much in height. Returns what is in its place then. */
    private TreeNode balanced(TreeNode node) {
        if (node.left == null || node.height < 2) {
            return node;
        }
        int difference = node.right.height - node.left.height;
        if (difference > 1) {
            return rotated(node, node.left, node.right, true);
        }
        if (difference < -1) {
            return rotated(node, node.right, node.left, false);
        }
        return node;
    }

    /** Puts the {@code high} child above {@code node}, which gets the lower child of {@code high} for it. */
    private TreeNode rotated(TreeNode node, TreeNode low, TreeNode high, boolean highIsRight) {
        TreeNode first = high.left;
        TreeNode second = high.right;
        boolean firstIsHigher = first.height > second.height;
        TreeNode kept = firstIsHigher ? first : second;
        TreeNode given = firstIsHigher ? second : first;
        replace(node, high);
        node.parent = high;
        high.left = node;
        high.right = kept;
        if (highIsRight) {
            node.right = given;
        } else {
            node.left = given;
        }
        given.parent = node;
        node.surround(low, given);
        high.surround(node, kept);
        node.height = 1 + Math.max(low.height, given.height);
        high.height = 1 + Math.max(node.height, kept.height);
        return high;
    }
}
