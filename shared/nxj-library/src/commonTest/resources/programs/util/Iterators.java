import java.util.ArrayList;
import java.util.HashSet;
import java.util.Iterator;
import java.util.LinkedList;
import java.util.List;
import java.util.ListIterator;
import java.util.NoSuchElementException;

public class Iterators {
    public static void main(String[] arguments) {
        LinkedList<Integer> list = new LinkedList<Integer>();
        for (int i = 0; i < 8; i++) list.add(i);
        ListIterator<Integer> walk = list.listIterator();
        while (walk.hasNext()) {
            int number = walk.next();
            if (number % 3 == 0) walk.remove();
            if (number % 3 == 1) walk.add(number * 10);
            if (number % 3 == 2) walk.set(-number);
        }
        System.out.println(list); // expect [1, 10, -2, 4, 40, -5, 7, 70]
        StringBuilder back = new StringBuilder();
        while (walk.hasPrevious()) back.append(walk.previousIndex()).append(':').append(walk.previous()).append(' ');
        System.out.println(back.toString().trim()); // expect 7:70 6:7 5:-5 4:40 3:4 2:-2 1:10 0:1
        Iterator<Integer> empty = new ArrayList<Integer>().iterator();
        try {
            empty.next();
        } catch (NoSuchElementException wrong) {
            System.out.println("nothing"); // expect nothing
        }
        try {
            list.iterator().remove();
        } catch (IllegalStateException wrong) {
            System.out.println("not yet"); // expect not yet
        }
        List<List<String>> nested = new ArrayList<List<String>>();
        for (int i = 0; i < 3; i++) {
            nested.add(new LinkedList<String>());
            for (int j = 0; j <= i; j++) nested.get(i).add(i + "" + j);
        }
        String joined = "";
        for (List<String> inner : nested) {
            for (String text : inner) joined += text + ";";
        }
        System.out.println(joined); // expect 00;10;11;20;21;22;
        List<Integer> numbers = new ArrayList<Integer>();
        for (int number : list) numbers.add(Math.abs(number));
        HashSet<Integer> seen = new HashSet<Integer>(numbers);
        seen.addAll(numbers);
        System.out.println(seen.size() + " " + seen.containsAll(numbers)); // expect 8 true
        for (int number : numbers) seen.remove(number);
        System.out.println(seen.isEmpty()); // expect true
        List<Integer> kept = new ArrayList<Integer>(list);
        List<Integer> wanted = new ArrayList<Integer>();
        wanted.add(40);
        wanted.add(-2);
        kept.retainAll(wanted);
        System.out.println(kept); // expect [-2, 40]
    }
}
