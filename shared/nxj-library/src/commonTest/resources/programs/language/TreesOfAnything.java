import java.util.ArrayList;
import java.util.List;

public class TreesOfAnything {
    static class Tree<K extends Comparable<K>, V> {
        private class Node {
            final K key;
            V value;
            Node left;
            Node right;

            Node(K key, V value) {
                this.key = key;
                this.value = value;
            }
        }

        private Node root;
        private int size;

        V put(K key, V value) {
            if (root == null) {
                root = new Node(key, value);
                size++;
                return null;
            }
            Node node = root;
            while (true) {
                int order = key.compareTo(node.key);
                if (order == 0) {
                    V old = node.value;
                    node.value = value;
                    return old;
                }
                Node next = order < 0 ? node.left : node.right;
                if (next == null) {
                    Node made = new Node(key, value);
                    if (order < 0) node.left = made; else node.right = made;
                    size++;
                    return null;
                }
                node = next;
            }
        }

        V get(K key) {
            Node node = root;
            while (node != null && key.compareTo(node.key) != 0) node = key.compareTo(node.key) < 0 ? node.left : node.right;
            return node == null ? null : node.value;
        }

        List<K> keys() {
            List<K> keys = new ArrayList<K>();
            collect(root, keys);
            return keys;
        }

        private void collect(Node node, List<K> keys) {
            if (node == null) return;
            collect(node.left, keys);
            keys.add(node.key);
            collect(node.right, keys);
        }
    }

    public static void main(String[] arguments) {
        Tree<String, Integer> tree = new Tree<String, Integer>();
        for (String word : new String[] {"m", "c", "x", "a", "d", "z", "m"}) {
            Integer old = tree.put(word, word.length() + tree.size);
            if (old != null) System.out.println("old " + old); // expect old 1
        }
        System.out.println(tree.keys() + " " + tree.size); // expect [a, c, d, m, x, z] 6
        System.out.println(tree.get("d") + " " + tree.get("q")); // expect 5 null
        Tree<Integer, String> numbers = new Tree<Integer, String>();
        for (int i = 0; i < 50; i++) numbers.put(i * 37 % 101, "n" + i);
        List<Integer> keys = numbers.keys();
        boolean isSorted = true;
        for (int i = 1; i < keys.size(); i++) isSorted &= keys.get(i - 1) < keys.get(i);
        System.out.println(isSorted + " " + keys.size() + " " + numbers.get(37)); // expect true 50 n1
        Tree<Long, Double> wide = new Tree<Long, Double>();
        wide.put(1L << 40, 0.5);
        wide.put(-1L, 1.5);
        System.out.println(wide.keys() + " " + wide.get(1L << 40)); // expect [-1, 1099511627776] 0.5
    }
}
