import java.util.LinkedList;

public class LinkedLists {
    public static void main(String[] arguments) {
        LinkedList<Integer> list = new LinkedList<Integer>();
        for (int i = 1; i <= 5; i++) {
            list.add(0, i);
            list.add(-i);
        }
        System.out.println(list); // expect [5, 4, 3, 2, 1, -1, -2, -3, -4, -5]
        System.out.println(list.get(0) + " " + list.get(list.size() - 1) + " " + list.get(3)); // expect 5 -5 2
        System.out.println(list.remove(0) + " " + list.remove(list.size() - 1) + " " + list.size()); // expect 5 -5 8
        list.add(2, 99);
        list.remove(Integer.valueOf(1));
        System.out.println(list); // expect [4, 3, 99, 2, -1, -2, -3, -4]
        try {
            list.get(8);
        } catch (IndexOutOfBoundsException wrong) {
            System.out.println("no such place"); // expect no such place
        }
    }
}
