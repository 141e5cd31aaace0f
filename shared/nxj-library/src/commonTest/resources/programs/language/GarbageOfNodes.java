public class GarbageOfNodes {
    static class Node {
        Node next;
        int[] data = new int[20];
        String name;

        Node(Node next, int number) {
            this.next = next;
            name = "node " + number;
            data[number % 20] = number;
        }
    }

    /** Makes a hundred times as much as fits into the memory, and keeps little. */
    public static void main(String[] arguments) {
        Node kept = null;
        int sum = 0;
        for (int i = 0; i < 5000; i++) {
            Node made = new Node(kept, i);
            if (i % 500 == 0) {
                kept = made;
            } else {
                sum += made.data[i % 20] + made.name.length();
            }
        }
        System.out.println(sum); // expect 12518804
        int count = 0;
        for (Node node = kept; node != null; node = node.next) {
            count++;
            sum += node.data[0] + node.name.length();
        }
        System.out.println(count + " " + sum); // expect 10 12541390
        long[][] grid = null;
        for (int i = 0; i < 300; i++) {
            grid = new long[10][20];
            grid[9][19] = i;
        }
        System.out.println(grid[9][19]); // expect 299
        String text = "";
        for (int i = 0; i < 300; i++) text = (text + i).substring(Math.max(0, text.length() - 20));
        System.out.println(text); // expect 92293294295296297298299
        Node circle = new Node(null, 1);
        circle.next = circle;
        circle = null;
        Object[] holder = new Object[3];
        holder[0] = holder;
        holder[1] = "self";
        System.gc();
        System.out.println(((Object[]) holder[0])[1]); // expect self
    }
}
