import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.StringTokenizer;

public class WordCount {
    static class Count implements Comparable<Count> {
        final String word;
        int times;

        Count(String word) {
            this.word = word;
        }

        public int compareTo(Count other) {
            return times != other.times ? other.times - times : word.compareTo(other.word);
        }

        @Override
        public String toString() {
            return word + "=" + times;
        }
    }

    static <T extends Comparable<T>> void sort(List<T> list) {
        for (int i = 1; i < list.size(); i++) {
            T one = list.get(i);
            int place = i;
            while (place > 0 && list.get(place - 1).compareTo(one) > 0) {
                list.set(place, list.get(place - 1));
                place--;
            }
            list.set(place, one);
        }
    }

    public static void main(String[] arguments) {
        String text = "the robot sees the line and the robot turns and the robot stops at the end of the line";
        Map<String, Count> counts = new HashMap<String, Count>();
        List<Count> sorted = new ArrayList<Count>();
        for (StringTokenizer words = new StringTokenizer(text, " "); words.hasMoreTokens();) {
            String word = words.nextToken();
            Count count = counts.get(word);
            if (count == null) {
                count = new Count(word);
                counts.put(word, count);
                sorted.add(count);
            }
            count.times++;
        }
        sort(sorted);
        System.out.println(sorted); // expect [the=6, robot=3, and=2, line=2, at=1, end=1, of=1, sees=1, stops=1, turns=1]
        int letters = 0;
        for (Count count : sorted) letters += count.word.length();
        System.out.println(letters); // expect 36
    }
}
