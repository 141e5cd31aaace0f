/** A program that makes far more objects than there is room for at once. */
public class GarbageCollected { // only here
    static class Node {
        Node next;
        long number;
    }

    public static void main(String[] args) {
        String text = "";
        int[] numbers = null;
        for (int i = 0; i < 500; i++) {
            numbers = new int[1000];
            numbers[999] = i;
            text = text.length() > 20 ? "" : text + i;
        }
        System.out.println(numbers[999] + " " + (text.length() < 30)); // expect 499 true
        Node first = null;
        int made = 0;
        try {
            while (true) {
                Node node = new Node();
                node.next = first;
                node.number = made;
                first = node;
                made++;
            }
        } catch (OutOfMemoryError e) {
            first = first.next;
        }
        System.out.println(made > 2000 && made < 4000); // expect true
        long sum = 0;
        for (Node node = first; node != null; node = node.next) sum += node.number;
        System.out.println(sum == (made - 2L) * (made - 1) / 2); // expect true
        first = null;
        System.out.println(new byte[30000].length); // expect 30000
        System.out.println(Runtime.getRuntime().freeMemory() < Runtime.getRuntime().totalMemory()); // expect true
    }
}
