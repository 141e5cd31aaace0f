package java.util;

/** What all maps can do once they have a set of keys with their values. */
public abstract class AbstractMap<K, V> implements Map<K, V> {
    /** Makes one. */
    protected AbstractMap() {
    }

    /** Gives how many keys there are. */
    public int size() {
        return entrySet().size();
    }

    /** Says whether there are no keys. */
    public boolean isEmpty() {
        return size() == 0;
    }

    /** Says whether there is such a key. */
    public boolean containsKey(Object key) {
        for (Map.Entry<K, V> entry : entrySet()) {
            if (AbstractCollection.isSame(key, entry.getKey())) return true;
        }
        return false;
    }

    /** Says whether there is such a value. */
    public boolean containsValue(Object value) {
        return values().contains(value);
    }

    /** Gives the value of a key, or null if there is no such key. */
    public V get(Object key) {
        for (Map.Entry<K, V> entry : entrySet()) {
            if (AbstractCollection.isSame(key, entry.getKey())) return entry.getValue();
        }
        return null;
    }

    /** Fails, unless the class knows better. */
    public V put(K key, V value) {
        throw new UnsupportedOperationException();
    }

    /** Sets all keys and values of the other map. */
    public void putAll(Map<? extends K, ? extends V> other) {
        for (Map.Entry<? extends K, ? extends V> entry : other.entrySet()) put(entry.getKey(), entry.getValue());
    }

    /** Takes out a key, and gives its value, or null. */
    public V remove(Object key) {
        for (Iterator<Map.Entry<K, V>> entries = entrySet().iterator(); entries.hasNext();) {
            Map.Entry<K, V> entry = entries.next();
            if (AbstractCollection.isSame(key, entry.getKey())) {
                entries.remove();
                return entry.getValue();
            }
        }
        return null;
    }

    /** Takes all keys out. */
    public void clear() {
        entrySet().clear();
    }

    /** Gives the keys; what is taken out of them is taken out of the map. */
    public Set<K> keySet() {
        return new Keys();
    }

    /** Gives the values; what is taken out of them is taken out of the map. */
    public Collection<V> values() {
        return new Values();
    }

    /** Says whether the other one is a map with the same keys and values. */
    public boolean equals(Object other) {
        return other == this || other instanceof Map && entrySet().equals(((Map<?, ?>) other).entrySet());
    }

    /** Gives a number that is the same for the same keys and values. */
    public int hashCode() {
        return entrySet().hashCode();
    }

    /** Gives all keys and values as text. */
    public String toString() {
        StringBuilder text = new StringBuilder("{");
        for (Map.Entry<K, V> entry : entrySet()) {
            if (text.length() > 1) text.append(", ");
            text.append(entry.getKey() == this ? "(this Map)" : (Object) entry.getKey()).append('=');
            text.append(entry.getValue() == this ? "(this Map)" : (Object) entry.getValue());
        }
        return text.append('}').toString();
    }

    private class Keys extends AbstractSet<K> {
        Keys() {
        }

        public int size() {
            return AbstractMap.this.size();
        }

        public boolean contains(Object key) {
            return containsKey(key);
        }

        public Iterator<K> iterator() {
            final Iterator<Map.Entry<K, V>> entries = entrySet().iterator();
            return new Iterator<K>() {
                public boolean hasNext() {
                    return entries.hasNext();
                }

                public K next() {
                    return entries.next().getKey();
                }

                public void remove() {
                    entries.remove();
                }
            };
        }
    }

    private class Values extends AbstractCollection<V> {
        Values() {
        }

        public int size() {
            return AbstractMap.this.size();
        }

        public Iterator<V> iterator() {
            final Iterator<Map.Entry<K, V>> entries = entrySet().iterator();
            return new Iterator<V>() {
                public boolean hasNext() {
                    return entries.hasNext();
                }

                public V next() {
                    return entries.next().getValue();
                }

                public void remove() {
                    entries.remove();
                }
            };
        }
    }
}
